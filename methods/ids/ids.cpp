// Item buffers: Weghorst, Hooper and Greenberg 1984; borders of ids as engines draw them. A line
// wherever two neighbours have different ids, or a pixel's four corners.

#include <algorithm>
#include <cstring>

#include "buffers/each_tile.h"
#include "buffers/id_pass.h"
#include "buffers/packed_sink.h"

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

class Ids : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        buffers::BorderSide side = buffers::BorderSide::nearer;
        int threshold = 128;  ///< it draws 0 and 255 alone
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        buffers::add_side_param(buffers::add_id_params(table));
        return method::add_threshold_of_two(buffers::add_depth_format_param(
            table, "Format of the depth test, which also decides the nearer side."));
    }
    explicit Ids(const Params& params) : IdMethod(params, 1), params_(params) {}

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        buffers::EachTile sink([&](const raster::Tile& tile) { draw_borders(tile, out); });
        return pass().draw_lines(frame, sink, out);
    }
    void draw_borders(const raster::Tile& tile, edge::EdgeImage& out) const {
        if (tile.is_empty) return buffers::clear_tile(tile, out);
        if (params_.samples == buffers::Samples::corner) return finish_corners(tile, out);
        if (params_.depth_format == raster::DepthFormat::q32) return finish_as<float>(tile, out);
        finish_as<std::uint32_t>(tile, out);
    }

    static void finish_corners(const raster::Tile& drawn, edge::EdgeImage& out) {
        const raster::Tile tile = buffers::output_tile(drawn, out.width_px(), out.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* upper = tile.row<std::uint32_t>(0, y);
            const auto* lower = tile.row<std::uint32_t>(0, y + 1);
            std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x) {
                const std::uint32_t id = upper[x];
                const std::uint32_t others =
                    (id ^ upper[x + 1]) | (id ^ lower[x]) | (id ^ lower[x + 1]);
                to[x] = others != 0 ? 255 : 0;
            }
        }
    }

    template <class Depth>
    void finish_as(const raster::Tile& tile, edge::EdgeImage& out) const {
        for (int y = 0; y < tile.height_px; ++y) {
            Stencil<Depth> at{};
            for (int row = 0; row < 3; ++row) {
                at.id[row] = tile.row<std::uint32_t>(0, y + row - 1);
                at.depth[row] = tile.depth_row<Depth>(y + row - 1);
            }
            std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
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
    /// Depth, too, where the nearer side is asked for.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        const bool reads_depth = params_.samples == buffers::Samples::centre &&
                                 params_.side == buffers::BorderSide::nearer;
        return {reads_depth ? 8.0 : 4.0, 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo ids_method() {
    return method::method_info<Ids>("ids");
}

}  // namespace ink::methods
