#include "shade/lay_ink.h"

#include <array>
#include <cassert>
#include <cmath>

namespace ink::shade {
namespace {

/// IEC 61966-2-1, of 0..1.
double light_of(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint8_t byte_of_light(double light) {
    const double value =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * value));
}

std::array<double, 256> light_of_bytes() {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = light_of(static_cast<double>(i) / 255);
    return light;
}

}  // namespace

core::Image<glm::u8vec3> lay_ink(const core::Image<std::uint8_t>& shares,
                                 core::Image<glm::u8vec3> image,
                                 const glm::u8vec3& color) {
    assert(shares.size() == image.size());
    const std::array<double, 256> light = light_of_bytes();
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double share = shares.data()[i] / 255.0;
        if (share == 0) continue;
        glm::u8vec3& pixel = image.data()[i];
        for (int channel = 0; channel < 3; ++channel) {
            const double under = light[pixel[channel]], over = light[color[channel]];
            pixel[channel] = byte_of_light(under + share * (over - under));
        }
    }
    return image;
}

}  // namespace ink::shade
