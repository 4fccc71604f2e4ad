#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace ink::shade {

/// A colour as files hold it.
using Rgb = glm::u8vec3;

/// Brightness 0 .. 1 as 0 .. 255, rounded and limited; no gamma, as 1998 drew. NaN becomes 0.
[[nodiscard]] Rgb to_8_bit(const glm::vec3& color);

/// What lines are drawn with.
struct Ink {
    Rgb color{0, 0, 0};
    int threshold = 128;  ///< 1..255: edge responses of at least this much are line
};

/// `image` with ink wherever an edge response reaches the threshold; both of the same size.
[[nodiscard]] core::Image<Rgb> compose(const core::Image<std::uint8_t>& edge_responses,
                                       core::Image<Rgb> image,
                                       const Ink& ink);

/// The mean of every n x n pixels, rounded to nearest per channel; width and height are multiples
/// of n >= 1.
[[nodiscard]] core::Image<Rgb> average(const core::Image<Rgb>& image, int n);
[[nodiscard]] core::Image<std::uint8_t> average(const core::Image<std::uint8_t>& image, int n);

}  // namespace ink::shade
