#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/image.h"

namespace ink::image_io {

using Rgb = glm::u8vec3;

/// An image file as 8-bit grey. Palette PNGs give their indices' colours converted as any other
/// RGB; colour is turned to luma (ITU-R 601: 299 R + 587 G + 114 B, rounded). 16-bit and float
/// files are refused, since their scale is anybody's guess.
///
/// Throws core::Error with where = the path: missing, empty, not an image, not 8-bit.
[[nodiscard]] core::Image<std::uint8_t> read_gray(const std::filesystem::path& path);

/// Writes a PNG beside `path` and renames it, so that a half-written file is never seen.
///
/// Throws core::Error with where = the path if it cannot be written.
void write_png(const core::Image<std::uint8_t>& image, const std::filesystem::path& path);
void write_png(const core::Image<Rgb>& image, const std::filesystem::path& path);

/// The same file as bytes, for pages that carry their pictures.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const core::Image<std::uint8_t>& image);
[[nodiscard]] std::vector<std::uint8_t> encode_png(const core::Image<Rgb>& image);

}  // namespace ink::image_io
