#include "methods/grey_lines/ink_method.h"

#include <algorithm>
#include <cmath>

#include "buffers/each_tile.h"
#include "core/parallel.h"
#include "methods/grey_lines/ink.h"
#include "scene/camera.h"

namespace ink::methods {

LineWidths::LineWidths(const WidthParams& params, const raster::DepthRange& range)
    : far_width_(params.far_width),
      near_at_(params.near_at),
      far_at_(std::max(params.far_at, params.near_at + 1e-9)),
      range_(range) {
    const auto set = [&](LineKind kind, double share) {
        half_px_[static_cast<std::size_t>(kind)] = static_cast<float>(params.width_px * share / 2);
    };
    set(LineKind::contour, params.contours);
    set(LineKind::boundary, params.contours);
    set(LineKind::crease, params.creases);
    set(LineKind::intersection, params.intersections);
    set(LineKind::seam, params.seams);
}

float LineWidths::share_at(double q) const {
    const double at = 1 - raster::encode_depth(raster::DepthEncoding::linear, 1 / q, range_);
    const double way = std::clamp((at - near_at_) / (far_at_ - near_at_), 0.0, 1.0);
    return static_cast<float>(1 + way * (far_width_ - 1));
}

AskedSides::AskedSides(const LookupPass& pass, const raster::Tile& tile) {
    const ScreenMesh& screen = pass.screen();
    SideList list;
    list_sides({.tile = tile,
                .face_bits = LookupWord::kFaceOfCoded,
                .faces = screen.mesh().faces,
                .facing = screen.facing()},
               pass.rule(),
               nullptr,
               list);
    for (std::size_t i = 0; i < list.count; ++i) {
        const std::uint32_t place = list.places[i];
        const int x = static_cast<int>(place >> 1 & 0x7f) - 1, y = static_cast<int>(place >> 8) - 1;
        // Those of the next tiles are theirs.
        if (x >= tile.width_px || y >= tile.height_px) continue;
        ((place & 1) != 0 ? down : right)[static_cast<std::size_t>(y)] |= std::uint64_t{1} << x;
    }
}

InkMethod::InkMethod(std::string_view name, const InkParams& params)
    : SurfaceMethod(params, CodedLookup{.method = name, .jump_px = params.jump_px, .trust = 4}),
      params_(params) {}

raster::SkipCounts InkMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    const int margin_px = static_cast<int>(std::ceil(params_.width_px / 2));
    method::Frame grown = frame;
    grown.view = scene::grown_view(frame.view, 2 * margin_px);
    const raster::TileGrid grid{grown.view.width_px + 1, grown.view.height_px + 1, 0};
    begin(grid);
    buffers::EachTile sink([&](const raster::Tile& tile) {
        if (!tile.is_empty) look(tile);
    });
    const raster::MeshResult result = pass().draw(grown, false, sink);
    pass().inputs().forget_image();
    pieces_.resize(static_cast<std::size_t>(grid.count()));
    core::parallel_for(pieces_.size(), frame.threads, [&](std::size_t tile) {
        pieces_[tile].clear();
        join(tile, pieces_[tile]);
    });
    draw_pieces(pieces_,
                {.columns = grid.columns(), .margin_px = margin_px, .threads = frame.threads},
                out);
    touch_up(margin_px, frame.threads, out);
    return result.skips;
}

}  // namespace ink::methods
