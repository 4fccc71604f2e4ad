#include "buffers/hidden_lines.h"

#include <algorithm>
#include <array>

namespace ink::buffers {

double KindWidths::of(EdgeKind kind) const {
    return std::array{0.0, contour_px, crease_px, boundary_px}.at(static_cast<std::size_t>(kind));
}

HiddenLines::HiddenLines(const HiddenLineParams& params)
    : DepthFill({.depth_format = params.depth_format}), params_(params) {}

raster::SkipCounts HiddenLines::fill(const method::Frame& frame) {
    raster::MeshInput input = see(frame);
    input.offset = {params_.offset_factor, params_.offset_units};
    return DepthFill::fill(input);
}

void HiddenLines::draw(const method::Frame& frame,
                       const std::vector<KnownEdge>& edges,
                       const KindWidths& widths,
                       edge::EdgeImage& out) {
    std::vector<double> each{widths.contour_px, widths.crease_px, widths.boundary_px};
    std::ranges::sort(each);
    each.erase(std::unique(each.begin(), each.end()), each.end());
    for (const double width_px : each) {
        if (width_px <= 0) continue;
        p_world_.clear();
        lines_.clear();
        for (const KnownEdge& edge : edges) {
            if (widths.of(edge.kind) != width_px) continue;
            const auto from = static_cast<std::uint32_t>(p_world_.size());
            p_world_.push_back(edge.a_world);
            p_world_.push_back(edge.b_world);
            lines_.push_back({from, from + 1});
        }
        raster::LineInput input;
        input.p_world = p_world_;
        input.lines = lines_;
        input.view = frame.view;
        input.width_px = width_px;
        input.threads = frame.threads;
        line_pass_.draw(input, depth(), out);
    }
}

HiddenLinesMethod::HiddenLinesMethod(const HiddenLineParams& params)
    : SurfaceMethod(params),
      widths_{.contour_px = params.width_contour_px, .crease_px = params.width_crease_px} {
    if (params.boundary_edges == BoundaryEdges::contour) widths_.boundary_px = widths_.contour_px;
    if (params.boundary_edges == BoundaryEdges::crease) widths_.boundary_px = widths_.crease_px;
}

raster::SkipCounts HiddenLinesMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    out.fill(0);
    const raster::SkipCounts skips = pass().fill(frame);
    pass().draw(frame, lines(frame), widths_, out);
    return skips;
}

}  // namespace ink::buffers
