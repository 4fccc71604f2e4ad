#include "raster/screen_vertex.h"

#include <cmath>

namespace ink::raster {
namespace {

constexpr double kLargest = 1e150;

bool is_usable(double v) {
    return std::abs(v) <= kLargest;  // false for NaN
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
    v.x_px = p_clip.x / p_clip.z;
    v.y_px = p_clip.y / p_clip.z;
    v.q = 1 / p_clip.z;
    v.x = static_cast<std::int32_t>(std::lrint(v.x_px * kSubpixels));
    v.y = static_cast<std::int32_t>(std::lrint(v.y_px * kSubpixels));
    return v;
}

}  // namespace ink::raster
