#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edge/edge_image.h"

namespace ink::harness {

/// Which pixels of an outline image are its lines.
enum class Polarity {
    automatic,      ///< dark on light if more than three quarters of the pixels are light
    light_on_dark,  ///< the lighter, the stronger
    dark_on_light   ///< the darker, the stronger
};

/// An outline image that was drawn elsewhere, as edge responses.
struct OutlineImage {
    edge::EdgeImage responses;  ///< 0 no line .. 255 the strongest
    bool is_inverted = false;   ///< the file has dark lines on light
    /// What was done to get the responses besides, a phrase each: another depth, what alpha was
    /// laid over, what of the colours was taken.
    std::vector<std::string> notes = {};
};

/// Whether an outline image has dark lines on light: more than three quarters of its pixels are 128
/// or lighter. Lines cover a small part of any image. An image of one value has no lines, and
/// is not taken for one; nor is an empty one.
[[nodiscard]] bool has_dark_lines(const core::Image<std::uint8_t>& image);

/// Reads any picture (image_io::read_picture) as an outline.
///
/// Where it has alpha, it is laid over the opposite of its lines: of lines alone, black if they are
/// light and white if they are dark; of opaque figures with lines on them, what most of these is.
/// `polarity` says which where it says something. Colours count by their luma, unless one of red,
/// green and blue or the distance from the commonest colour tells lines from ground better: then
/// that is taken. Only thin shapes on a ground of one colour are lines of that sort, not a shading.
/// An image of a single value has no lines, and is taken as it is where `polarity` is automatic.
///
/// Throws core::Error as image_io::read_picture does.
[[nodiscard]] OutlineImage read_outline_image(const std::filesystem::path& path,
                                              Polarity polarity = Polarity::automatic);

}  // namespace ink::harness
