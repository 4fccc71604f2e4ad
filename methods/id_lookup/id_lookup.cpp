// New here, after item buffers (Weghorst, Hooper and Greenberg 1984): triangle ids, and the line
// between two that differ looked up in the mesh, with its class.

#include "methods/id_lookup/id_lookup.h"

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::methods {
namespace {

/// The classes of a tile's own pixels, and of a pixel more on every side, which nobody reads.
class TileKinds {
  public:
    [[nodiscard]] LineKind* row(int y) { return kinds_.data() + (y + 1) * kSpan + 1; }
    void clear(int rows) {
        std::fill_n(kinds_.begin(), static_cast<std::size_t>(rows + 2) * kSpan, LineKind::none);
    }
    /// A pixel that two lines run through shows that of the lower number.
    void mark(int x, int y, LineKind kind) {
        LineKind& at = row(y)[x];
        if (at == LineKind::none || kind < at) at = kind;
    }

  private:
    static constexpr int kSpan = raster::kTileSize_px + 2;
    std::array<LineKind, static_cast<std::size_t>(kSpan) * kSpan> kinds_;
};

/// Looks up the sides between samples that differ and marks the pixels of their lines.
class SideLookup {
  public:
    SideLookup(const ScreenMesh& screen, buffers::Samples samples, const raster::Tile& tile)
        : screen_(screen), has_corners_(samples == buffers::Samples::corner), tile_(tile) {}

    /// False if no sample differs from another: then `kinds` holds nothing of use.
    bool look_up(TileKinds& kinds) const {
        // Of corners the tile's own and those right of and below them; of centres those on all
        // four sides.
        const int first = has_corners_ ? 0 : -1;
        bool is_clear = false;
        for (int y = first; y <= tile_.height_px; ++y) {
            const auto* row = tile_.row<std::uint32_t>(0, y);
            const bool has_below = y < tile_.height_px;
            const auto* below = has_below ? tile_.row<std::uint32_t>(0, y + 1) : row;
            if (!differs(row, below, first)) continue;
            if (!is_clear) kinds.clear(tile_.height_px);
            is_clear = true;
            for (int x = first; x <= tile_.width_px; ++x) {
                const bool has_right = x < tile_.width_px;
                if (has_right && row[x] != row[x + 1]) mark(kinds, x, y, false, row[x], row[x + 1]);
                if (has_below && row[x] != below[x]) mark(kinds, x, y, true, row[x], below[x]);
            }
        }
        return is_clear;
    }

  private:
    [[nodiscard]] bool differs(const std::uint32_t* row,
                               const std::uint32_t* below,
                               int first) const {
        std::uint32_t all = 0;
        for (int x = first; x < tile_.width_px; ++x)
            all |= (row[x] ^ row[x + 1]) | (row[x] ^ below[x]);
        return (all | (row[tile_.width_px] ^ below[tile_.width_px])) != 0;
    }

    void mark(TileKinds& kinds,
              int x,
              int y,
              bool is_down,
              std::uint32_t first,
              std::uint32_t second) const {
        const FoundLine line =
            screen_.line_between({tile_.x0_px + x, tile_.y0_px + y, is_down, first, second});
        if (line.kind == LineKind::none) return;
        if (has_corners_) {  // the side of two pixels
            kinds.mark(x, y, line.kind);
            kinds.mark(is_down ? x - 1 : x, is_down ? y : y - 1, line.kind);
        } else {
            const int step = line.s < 0.5 ? 0 : 1;
            kinds.mark(is_down ? x : x + step, is_down ? y + step : y, line.kind);
        }
    }

    const ScreenMesh& screen_;
    bool has_corners_;
    const raster::Tile& tile_;
};

/// A sink that hands each row of each tile to `write(tile, y, kinds)`; `kinds` is null where no
/// pixel of it is a line.
template <class Image, class Write>
auto row_sink(const ScreenMesh& screen, buffers::Samples samples, const Image& image, Write write) {
    const int width_px = image.width_px();
    const int height_px = image.height_px();
    return buffers::EachTile([&screen, samples, width_px, height_px, write](const auto& drawn) {
        const raster::Tile tile = buffers::output_tile(drawn, width_px, height_px);
        if (tile.width_px == 0 || tile.height_px == 0) return;
        TileKinds kinds;
        const bool has_lines = !tile.is_empty && SideLookup(screen, samples, tile).look_up(kinds);
        for (int y = 0; y < tile.height_px; ++y)
            write(tile, y, has_lines ? kinds.row(y) : nullptr);
    });
}

/// As pictures of the truth have them, by kind: paper, contours, boundaries, creases, intersections
/// and seams.
glm::u8vec3 color_of(LineKind kind) {
    static const std::array<glm::u8vec3, 6> kColors = {{{255, 255, 255},
                                                        {32, 36, 42},
                                                        {204, 121, 167},
                                                        {0, 158, 115},
                                                        {230, 159, 0},
                                                        {86, 180, 233}}};
    return kColors.at(static_cast<std::size_t>(kind));
}

}  // namespace

core::ParamTable<IdLookup::Params> IdLookup::table() {
    core::ParamTable<Params> table;
    buffers::add_crease_param(table, "Least dihedral deviation of an edge that is a crease.")
        .number(&Params::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Boundaries of an object this near meet, as a share of its diagonal.")
        .number(&Params::steps,
                "steps",
                {1, 1000},
                "",
                "Most triangles crossed from one sample to the next before it gives up.");
    buffers::add_depth_format_param(buffers::add_samples_param(table));
    return method::add_threshold_of_two(table);
}

FacePass::FacePass(const IdLookupParams& params)
    : ConstantPass(buffers::constant_inputs(params),
                   buffers::constant_format(raster::Store::u32, params.depth_format, 1),
                   kNoNeighbour),
      params_(params) {}

std::vector<std::uint32_t> FacePass::constants_of(const scene::PreparedScene& scene) {
    mesh_ = make_lookup_mesh(
        scene,
        {.crease_rad = glm::radians(params_.crease_deg), .weld_epsilon = params_.weld_epsilon});
    return mesh_.face_of_triangle;
}

void FacePass::follow_view(const method::Frame& frame) {
    screen_.see(mesh_,
                inputs().view(),
                {.crease_rad = glm::radians(params_.crease_deg), .most_steps = params_.steps},
                frame.threads);
}

raster::SkipCounts IdLookup::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    const auto write = [&](const raster::Tile& tile, int y, const LineKind* kinds) {
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        if (kinds == nullptr) {
            std::fill_n(to, tile.width_px, std::uint8_t{0});
            return;
        }
        for (int x = 0; x < tile.width_px; ++x)
            to[x] = kinds[x] == LineKind::none ? 0 : 255;
    };
    auto sink = row_sink(pass().screen(), params_.samples, out, write);
    return pass().draw_lines(frame, sink, out);
}

core::Image<LineKind> IdLookup::classes(const method::Frame& frame) {
    core::Image<LineKind> image(frame.view.width_px, frame.view.height_px, LineKind::none);
    if (pass().is_empty()) return image;
    const auto write = [&](const raster::Tile& tile, int y, const LineKind* kinds) {
        if (kinds == nullptr) return;
        std::copy_n(kinds, tile.width_px, image.row(tile.y0_px + y) + tile.x0_px);
    };
    auto sink = row_sink(pass().screen(), params_.samples, image, write);
    (void)pass().draw(frame, false, sink);
    pass().inputs().forget_image();
    return image;
}

std::vector<method::Layer> IdLookup::layers(const method::Frame& frame) {
    return {{"classes", core::mapped<glm::u8vec3>(classes(frame), color_of)}};
}

method::MethodInfo id_lookup_method() {
    return method::method_info<IdLookup>("id_lookup");
}

}  // namespace ink::methods
