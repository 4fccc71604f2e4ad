#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/image.h"

namespace ink::image_io {

/// Floats that are kept as 16-bit ones: exact for whole numbers up to 2048 and for k/255 to 3
/// digits.
struct HalfImage {
    core::Image<float> pixels;
};

/// One channel of an OpenEXR file, stored as UINT, FLOAT or HALF.
///
/// Names follow OpenEXR ("Technical Introduction", Channel Names): R, G, B, A, Y and Z for the
/// image itself; `layer.channel` for the rest, which compositors show as layers.
struct ExrChannel {
    std::string name;
    std::variant<core::Image<std::uint32_t>, core::Image<float>, HalfImage> pixels;
};

/// One entry of a file's header. A name with a colon is ours; others are OpenImageIO's or
/// OpenEXR's own. Matrices are by rows, for row vectors, as OpenEXR has them.
struct ExrAttribute {
    std::string name;
    std::variant<std::string, double, std::array<float, 16>> value;
};

/// A multi-channel OpenEXR file, or what is read of one.
struct ExrFile {
    std::vector<ExrChannel> channels;
    std::vector<ExrAttribute> attributes;
};

/// Writes one part with lossless ZIP compression beside `path` and renames it, so that a
/// half-written file is never seen. Infinities and NaN are kept as they are.
///
/// Throws core::Error with where = the path if it cannot be written, if there is no channel or the
/// image is empty; nothing is left behind then. Channels of different sizes or of one name are a
/// caller's bug.
void write_exr(const ExrFile& file, const std::filesystem::path& path);

/// Reads every channel of the first part in its own type (others than the three do not occur in
/// OpenEXR), sorted by name, and every attribute that is a text or a single number, as far as
/// OpenImageIO hands them on. The image is the display window: what lies outside is left out, and
/// pixels that the file does not hold are 0.
///
/// Throws core::Error with where = the path if it is missing, not OpenEXR, damaged or larger than
/// 2^27 pixels.
[[nodiscard]] ExrFile read_exr(const std::filesystem::path& path);

}  // namespace ink::image_io
