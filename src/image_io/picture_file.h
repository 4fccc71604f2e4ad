#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image.h"
#include "image_io/image_file.h"

namespace ink::image_io {

/// An image file of any depth as a screen shows it, 8 bits a channel.
struct Picture {
    core::Image<Rgb> colour;          ///< straight: not multiplied by alpha
    core::Image<std::uint8_t> alpha;  ///< empty where the file has none, and holds all pixels
    /// What was done to get there, a phrase each: another depth, which of several layers.
    std::vector<std::string> notes = {};
    Texts texts = {};  ///< of the file (GrayFile)
};

/// Reads a picture from elsewhere: grey or colour, 8 or 16 bits, or float, with alpha or without.
///
/// 16 bits are rounded to 8. Float values (OpenEXR) are light: 0..1 becomes sRGB, as on a screen,
/// what lies outside is cut. Of a file with layers the image itself is taken (R, G, B or Y), else
/// the first layer that has colours (`layer.R`), else the first that has grey. An OpenEXR file
/// shows its display window; what it does not hold of that has alpha 0.
///
/// Throws core::Error with where = the path: missing, empty, not an image, cut off, without colour
/// or grey, with a value that is no finite number, or larger than 2^27 pixels.
[[nodiscard]] Picture read_picture(const std::filesystem::path& path);

}  // namespace ink::image_io
