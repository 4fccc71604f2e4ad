#include "methods/ids/ids.h"

#include <algorithm>
#include <cstring>

#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::methods {
namespace {

/// Three rows of ids and of depths, from the same column on.
template <class Depth>
struct Stencil {
    const std::uint32_t* id[3];
    const Depth* depth[3];

    /// Whether the pixel owns a border with its neighbour: the nearer owns it, the lower id if they
    /// are as near. Sky has depth 0, so it owns none.
    [[nodiscard]] bool owns(int x, int row, int to) const {
        const std::uint32_t mine = id[1][x];
        const std::uint32_t other = id[row][to];
        const Depth d = depth[1][x];
        const Depth e = depth[row][to];
        return mine != other && (d > e || (d == e && mine < other));
    }
    [[nodiscard]] bool owns_any(int x) const {
        return owns(x, 0, x) || owns(x, 2, x) || owns(x, 1, x - 1) || owns(x, 1, x + 1);
    }
};

class IdSink : public raster::TileSink {
  public:
    IdSink(const Ids::Params& params, edge::EdgeImage& out) : params_(params), out_(out) {}

    void finish(const raster::Tile& tile) override {
        if (tile.is_empty) return buffers::clear_tile(tile, out_);
        if (params_.samples == buffers::Samples::corner) return finish_corners(tile);
        if (params_.depth_format == raster::DepthFormat::q32) return finish_as<float>(tile);
        finish_as<std::uint32_t>(tile);
    }

  private:
    void finish_corners(const raster::Tile& drawn) {
        const raster::Tile tile = buffers::output_tile(drawn, out_.width_px(), out_.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* upper = tile.row<std::uint32_t>(0, y);
            const auto* lower = tile.row<std::uint32_t>(0, y + 1);
            std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x) {
                const std::uint32_t id = upper[x];
                const std::uint32_t others =
                    (id ^ upper[x + 1]) | (id ^ lower[x]) | (id ^ lower[x + 1]);
                to[x] = others != 0 ? 255 : 0;
            }
        }
    }

    template <class Depth>
    void finish_as(const raster::Tile& tile) {
        for (int y = 0; y < tile.height_px; ++y) {
            Stencil<Depth> at{};
            for (int row = 0; row < 3; ++row) {
                at.id[row] = tile.row<std::uint32_t>(0, y + row - 1);
                at.depth[row] = tile.depth_row<Depth>(y + row - 1);
            }
            std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
            mark_differences(at.id, tile.width_px, to);
            if (params_.side == buffers::BorderSide::nearer) keep_own(at, tile.width_px, to);
        }
    }

    /// 255 where an id is not that of all four neighbours. Most pixels lie inside, so the loop is
    /// one that a compiler makes vectors of.
    static void mark_differences(const std::uint32_t* const (&id)[3], int width, std::uint8_t* to) {
        const std::uint32_t* const above = id[0];
        const std::uint32_t* const here = id[1];
        const std::uint32_t* const below = id[2];
        for (int x = 0; x < width; ++x) {
            const std::uint32_t others = (here[x] ^ above[x]) | (here[x] ^ below[x]) |
                                         (here[x] ^ here[x - 1]) | (here[x] ^ here[x + 1]);
            to[x] = others != 0 ? 255 : 0;
        }
    }

    /// Takes out the marks of borders that the neighbour owns; eight pixels at a time have none.
    template <class Depth>
    static void keep_own(const Stencil<Depth>& at, int width, std::uint8_t* to) {
        constexpr int kStep = 8;
        for (int x0 = 0; x0 < width; x0 += kStep) {
            const int x1 = std::min(x0 + kStep, width);
            if (x1 - x0 == kStep) {
                std::uint64_t marks = 0;
                std::memcpy(&marks, to + x0, sizeof marks);
                if (marks == 0) continue;
            }
            for (int x = x0; x < x1; ++x) {
                if (to[x] != 0 && !at.owns_any(x)) to[x] = 0;
            }
        }
    }

    const Ids::Params& params_;
    edge::EdgeImage& out_;
};

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Contours of objects alone.
        {{"of", "object"}},
        {{"of", "object"}, {"side", "both"}},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // What lies coplanar side by side in two objects is one.
        {{"of", "patch"}},
        {{"of", "patch"}, {"side", "both"}},
        // Blunter creases only.
        {{"crease_deg", "60"}},
        // Nothing welded but what is bit-identical.
        {{"weld_epsilon", "0"}},
        // Two pixels wide, which no turn of a border makes thinner.
        {{"side", "both"}},
        // The line in the pixel that it runs in.
        {{"samples", "corner"}},
        {},
    };
}

}  // namespace

core::ParamTable<Ids::Params> Ids::table() {
    core::ParamTable<Params> table;
    return buffers::add_side_param(buffers::add_id_params(table))
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth test, which also decides the nearer side.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel; it draws only 0 and 255.");
}

Ids::Ids(const Params& params) : buffers::IdMethod(params, 1), params_(params) {}

raster::SkipCounts Ids::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    IdSink sink(params_, out);
    return pass().draw_lines(frame, sink, out);
}

method::Cost Ids::cost() const {
    method::Cost cost = pass().cost();
    // Four comparisons, joined; on a border's side four more of depth, which few pixels reach.
    cost.filter = {sizeof(std::uint32_t), 1, 4 + 3};
    if (params_.samples == buffers::Samples::corner) {
        // Three differences, joined; no depth.
        cost.filter.operations = 3 + 2 + 1;
    } else if (params_.side == buffers::BorderSide::nearer) {
        cost.filter.bytes_read += 4;
    }
    return cost;
}

method::MethodInfo ids() {
    method::MethodInfo info = method::method_info<Ids>(
        "ids",
        "item buffers: Weghorst, Hooper and Greenberg 1984; borders of ids as engines draw them",
        "a line wherever neighbours belong to other objects or smooth patches");
    info.family = method::Family::ids;
    info.marker = method::Marker::circle;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
