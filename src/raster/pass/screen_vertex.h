#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace ink::raster {

/// Snapped coordinates are in 1/256 px: 8 bits after the point.
inline constexpr int kSubpixelBits = 8;
inline constexpr std::int32_t kSubpixels = 1 << kSubpixelBits;

/// a / b rounded down.
[[nodiscard]] inline std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

/// The guard band: triangles are cut at |x|, |y| = 2^20 px. Snapped coordinates then fit 29 bits
/// with sign, an edge function 60 bits: everything below is exact in 64-bit integers.
inline constexpr double kGuardBand_px = 1 << 20;

/// Why a vertex cannot be put on the screen as it is; bits of an outcode.
enum Outside : std::uint8_t {
    kInside = 0,
    kBeforeNear = 1,
    kLeft = 2,
    kRight = 4,
    kAbove = 8,
    kBelow = 16,
    kNotANumber = 32,  ///< not finite, or so large (1e150) that products would not be
};

/// The planes of near and guard band that `p_clip` = (x, y, w) lies beyond.
[[nodiscard]] std::uint8_t outcode(const glm::dvec3& p_clip, double near);

/// Within this reach positions are rounded to 1/65536 px first and to 1/256 px from there, so that
/// a vertex of 32 bits tells both where planes run and where coverage ends.
inline constexpr double kLaneReach_px = 1 << 13;
inline constexpr int kLaneBits = 16;  ///< after the point

/// A position in 1/65536 px as coverage has it, in 1/256 px: to the nearest, halves up.
[[nodiscard]] constexpr std::int32_t snapped(std::int32_t fixed) {
    return (fixed + (1 << (kLaneBits - kSubpixelBits - 1))) >> (kLaneBits - kSubpixelBits);
}

/// A vertex as the setup needs it. The unsnapped position carries planes, the snapped one coverage.
struct ScreenVertex {
    double x_px = 0;
    double y_px = 0;
    double q = 0;        ///< 1/w
    std::int32_t x = 0;  ///< x_px in 1/256 px
    std::int32_t y = 0;
};

/// The screen vertex of a point with outcode kInside (or just cut, so outside by no more than
/// rounding).
[[nodiscard]] ScreenVertex to_screen(const glm::dvec3& p_clip);

}  // namespace ink::raster
