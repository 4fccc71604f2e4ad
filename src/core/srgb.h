#pragma once

#include <cmath>

namespace ink::core {

/// The light that a screen gives for a value, both 0..1 (sRGB, IEC 61966-2-1).
[[nodiscard]] inline double light_of(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The value for which a screen gives that light.
[[nodiscard]] inline double value_of(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace ink::core
