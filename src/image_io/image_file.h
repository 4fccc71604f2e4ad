#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/whole_file.h"

namespace ink::image_io {

using Rgb = glm::u8vec3;

/// Texts of an image file by name: what a PNG has in its text chunks.
using Texts = std::map<std::string, std::string>;

/// Says of an image, as "linear", that lines cover of a grey pixel what it lacks of the light of
/// white.
inline constexpr const char* kMixedText = "ink:mixed";

/// A file as grey, and whether it was more than that.
struct GrayFile {
    core::Image<std::uint8_t> pixels;
    bool has_colour = false;  ///< a pixel's red, green and blue differ
    Texts texts = {};         ///< of the file, ours ("ink:band_px") and others'
};

/// An image file as 8-bit grey, (0,0) top left, values as they are in the file.
///
/// Colour becomes luma (ITU-R 601: 0.299 R + 0.587 G + 0.114 B in 16-bit fixed point, rounded),
/// palette images by their colours; alpha is left out, not multiplied in. Grey of 1, 2 or 4 bits
/// is spread to 0..255. 16-bit and float files are refused, since their scale is anybody's guess.
///
/// Throws core::Error with where = the path: missing, empty, not an image, cut off, not 8-bit, or
/// larger than 2^27 pixels.
[[nodiscard]] GrayFile read_gray_file(const std::filesystem::path& path);

/// Its pixels alone, for whoever takes colours for grey.
[[nodiscard]] inline core::Image<std::uint8_t> read_gray(const std::filesystem::path& path) {
    return read_gray_file(path).pixels;
}

/// How bright a colour is: ITU-R 601 in the 16-bit fixed point that image programs share, so that
/// all of them see one grey. Of a grey it is that grey.
[[nodiscard]] constexpr std::uint8_t luma(const Rgb& rgb) {
    return static_cast<std::uint8_t>((rgb.r * 19595U + rgb.g * 38470U + rgb.b * 7471U + 0x8000U) >>
                                     16);
}

/// A grey or RGB image as a PNG takes it; borrows the image.
struct PngPixels {
    // Any such image is meant where these are asked for.
    PngPixels(const core::Image<std::uint8_t>& image)
        : data(image.data()), width_px(image.width_px()), height_px(image.height_px()) {}
    PngPixels(const core::Image<Rgb>& image)
        : data(image.data()),
          width_px(image.width_px()),
          height_px(image.height_px()),
          channels(sizeof(Rgb)) {}

    const void* data;
    int width_px;
    int height_px;
    int channels = 1;
};

/// A PNG as bytes, for pages that carry their images; `texts` become text chunks. Throws
/// core::Error on an empty image, with `where`.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const PngPixels& image,
                                                   const Texts& texts = {},
                                                   const std::string& where = "png");

/// Writes it beside `path` and renames it, so that a half-written file is never seen.
///
/// Throws core::Error with where = the path if it cannot be written or the image is empty; nothing
/// is left behind then, and a file that was there before stays.
inline void write_png(const PngPixels& image,
                      const std::filesystem::path& path,
                      const Texts& texts = {}) {
    const std::vector<std::uint8_t> bytes = encode_png(image, texts, path.string());
    core::write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

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
