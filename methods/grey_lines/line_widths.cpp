#include "methods/grey_lines/line_widths.h"

#include <algorithm>

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

}  // namespace ink::methods
