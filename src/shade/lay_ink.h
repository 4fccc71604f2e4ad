#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace ink::shade {

/// `image` with ink of one colour over it, which covers `shares` of each pixel, of 255; both of the
/// same size.
///
/// Mixed in linear light, for a share of a pixel is one of its light: sRGB is taken out of both
/// colours and put back once. A share of 0 changes nothing, one of 255 is the colour. Light lines
/// on a dark picture look heavier than dark ones on a light one, most at a pixel's width: half a
/// pixel's light looks nearer to white. Their light is the same, as in any mean of many samples.
[[nodiscard]] core::Image<glm::u8vec3> lay_ink(const core::Image<std::uint8_t>& shares,
                                               core::Image<glm::u8vec3> image,
                                               const glm::u8vec3& color);

}  // namespace ink::shade
