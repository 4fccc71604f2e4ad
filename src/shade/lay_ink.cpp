#include "shade/lay_ink.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/srgb.h"

namespace ink::shade {
namespace {

std::uint8_t byte_of_light(double light) {
    return static_cast<std::uint8_t>(std::lround(255 * core::value_of(light)));
}

std::array<double, 256> light_of_bytes() {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = core::light_of(static_cast<double>(i) / 255);
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
