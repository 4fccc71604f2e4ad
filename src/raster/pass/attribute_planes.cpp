#include "raster/pass/attribute_planes.h"

#include <algorithm>
#include <cmath>

namespace ink::raster {
namespace {

constexpr double kOne = 1 << kCodeFractionBits;
constexpr double kSteepest = 0x1p40;  // times 2^16 pixels stays below 2^57
constexpr double kFarthest = 0x1p60;

/// Rounded to the nearest, halves up, so that no mode of the machine matters; limited to +-`limit`.
std::int64_t to_fixed(double value, double limit) {
    return static_cast<std::int64_t>(std::floor(std::clamp(value * kOne, -limit, limit) + 0.5));
}

std::int64_t floor_to_fixed(double value) {
    return static_cast<std::int64_t>(std::clamp(std::floor(value) * kOne, -kFarthest, kFarthest));
}

}  // namespace

CodePlane make_code_plane(const PlaneMaker& maker,
                          const PerCorner& values,
                          std::uint32_t constant) {
    const Plane plane = maker.through(values);
    const auto offset = static_cast<std::int64_t>(constant) << kCodeFractionBits;
    const auto [lowest, highest] = std::minmax({values[0], values[1], values[2]});
    CodePlane code;
    code.at_ref = to_fixed(plane.at_ref, kFarthest) + offset;
    code.dx = to_fixed(plane.dx, kSteepest);
    code.dy = to_fixed(plane.dy, kSteepest);
    code.lowest = floor_to_fixed(lowest) + offset;
    code.highest = floor_to_fixed(highest) + offset;
    return code;
}

FloatPlane make_affine_plane(const PlaneMaker& maker, const PerCorner& values) {
    const auto [lowest, highest] = std::minmax({values[0], values[1], values[2]});
    return {maker.through(values), static_cast<float>(lowest), static_cast<float>(highest)};
}

FloatPlane make_perspective_plane(const PlaneMaker& maker,
                                  const PerCorner& values,
                                  const PerCorner& q) {
    FloatPlane result = make_affine_plane(maker, values);
    result.plane = maker.through({values[0] * q[0], values[1] * q[1], values[2] * q[2]});
    return result;
}

}  // namespace ink::raster
