#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace ink::shade {

/// A colour as files hold it.
using Rgb = glm::u8vec3;

/// What a frame buffer keeps of a colour.
enum class DitherFormat {
    none,    ///< all of it
    rgb565,  ///< 5, 6 and 5 bits
    rgb332,  ///< 3, 3 and 2 bits
};

/// Per channel the highest level of a format: 31, 63, 31 or 7, 7, 3; 255 for `none`.
[[nodiscard]] std::array<int, 3> top_levels(DitherFormat format);

/// Ordered dither, as 1998 saved bits: each channel becomes one of the two levels about it, by
/// place.
///
/// Of value v and top level t, v t / 255 is cut to whole levels, and a level is added where the
/// rest exceeds (rank + 1/2) / 16. So an even colour keeps its mean over 4x4 pixels within 1/32
/// level, and a colour that is a level stays as it is. Levels come back as 0..255, rounded.
[[nodiscard]] core::Image<Rgb> dither(core::Image<Rgb> image, DitherFormat format);

/// Every pixel becomes the strongest one within a disc round it: a line of one pixel becomes
/// `diameter_px` wide (1 changes nothing).
///
/// A disc of odd diameter has its centre on a pixel centre, one of even diameter on the corner
/// above and left of it; it holds the pixel centres at most diameter/2 away. Outside the image is
/// nothing. Costs in proportion to the pixels that are not 0 times the disc.
[[nodiscard]] core::Image<std::uint8_t> widen(const core::Image<std::uint8_t>& edge_responses,
                                              int diameter_px);

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

/// The mean of every n x n pixels, rounded to nearest per channel; width and height are multiples
/// of n >= 1.
[[nodiscard]] core::Image<Rgb> average(const core::Image<Rgb>& image, int n);
[[nodiscard]] core::Image<std::uint8_t> average(const core::Image<std::uint8_t>& image, int n);

}  // namespace ink::shade
