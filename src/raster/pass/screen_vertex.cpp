#include "raster/pass/screen_vertex.h"

#include <algorithm>
#include <cmath>

namespace ink::raster {
namespace {

constexpr double kLargest = 1e150;

bool is_usable(double v) {
    return std::abs(v) <= kLargest;  // false for NaN
}

std::int32_t snap(double px) {
    if (std::abs(px) > kLaneReach_px) {
        // A corner that was cut off an edge without end may lie beyond the band by any rounding.
        constexpr double kMost_px = kGuardBand_px + 1;
        const double held_px = std::clamp(px, -kMost_px, kMost_px);
        return static_cast<std::int32_t>(std::lrint(held_px * kSubpixels));
    }
    return snapped(static_cast<std::int32_t>(std::lrint(px * (1 << kLaneBits))));
}

}  // namespace

std::uint8_t outcode(const glm::dvec3& p_clip, double near) {
    if (!is_usable(p_clip.x) || !is_usable(p_clip.y) || !is_usable(p_clip.z)) return kNotANumber;
    const double band = kGuardBand_px * p_clip.z;
    int code = kInside;
    if (p_clip.z < near) code |= kBeforeNear;
    if (p_clip.x < -band) code |= kLeft;
    if (p_clip.x > band) code |= kRight;
    if (p_clip.y < -band) code |= kAbove;
    if (p_clip.y > band) code |= kBelow;
    return static_cast<std::uint8_t>(code);
}

ScreenVertex to_screen(const glm::dvec3& p_clip) {
    ScreenVertex v;
    v.q = 1 / p_clip.z;
    v.x_px = p_clip.x * v.q;  // a product, not a quotient: as the lanes have it
    v.y_px = p_clip.y * v.q;
    v.x = snap(v.x_px);
    v.y = snap(v.y_px);
    return v;
}

}  // namespace ink::raster
