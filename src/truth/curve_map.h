#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "core/image.h"
#include "truth/curve.h"

namespace ink::truth {

/// Calls `visit(x, y)` for the pixel of each sample of a curve, every 1/16 px along it, both ends
/// included, rounded down: the one rule of which pixels a line is drawn in. A pixel is visited as
/// often as samples fall into it, and may lie outside the image.
template <class Visit>
void visit_pixels(const Curve& curve, Visit visit) {
    constexpr double kSamplesPerPx = 16;
    const double dx = curve.end.x_px - curve.begin.x_px;
    const double dy = curve.end.y_px - curve.begin.y_px;
    const int steps = static_cast<int>(std::ceil(std::hypot(dx, dy) * kSamplesPerPx));
    for (int i = 0; i <= steps; ++i) {
        const double s = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
        visit(static_cast<int>(std::floor(curve.begin.x_px + s * dx)),
              static_cast<int>(std::floor(curve.begin.y_px + s * dy)));
    }
}

inline constexpr std::uint32_t kNoCurve = 0xffffffffU;

/// Which curve drew each pixel of the truth image: an index into `curves`, kNoCurve where none did.
///
/// Of several curves in a pixel the one of the lowest class counts, of those the first, so that its
/// class is the pixel's label in draw_labels. Not thinned, and crowded blocks are not left out.
[[nodiscard]] core::Image<std::uint32_t> draw_curve_map(std::span<const Curve> curves,
                                                        int width_px,
                                                        int height_px);

}  // namespace ink::truth
