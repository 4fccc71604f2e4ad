#pragma once

/// The one door to OpenImageIO, for the sources of this room alone: no header that others include
/// comes through here.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.h"
#include "image_io/image_file.h"

namespace ink::image_io {

/// The first line of another library's message, short enough for one: what follows are
/// consequences.
[[nodiscard]] inline std::string one_line(std::string text) {
    text = text.substr(0, text.find('\n'));
    constexpr std::size_t kLongest = 160;
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

/// The texts of a file's header.
[[nodiscard]] Texts texts_of(const OIIO::ImageSpec& spec);

/// A file that was opened, and what its library says of it.
struct OpenFile {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;  ///< its size is that of the pixels that the file holds
    std::string path;
    const char* accepted = "";  ///< for messages
    /// The image: the display window of an OpenEXR file, else all pixels.
    int width_px = 0;
    int height_px = 0;
    /// Where the held pixels begin in the image. They may cover less of it (a crop) or more.
    int left_px = 0;
    int top_px = 0;

    /// Whether the file holds this pixel of the image.
    [[nodiscard]] bool holds(int x, int y) const {
        return x >= left_px && y >= top_px && x - left_px < spec.width && y - top_px < spec.height;
    }
    [[nodiscard]] bool holds_all() const {
        return holds(0, 0) && holds(width_px - 1, height_px - 1);
    }
    /// Whether the image is what the file holds, no crop and no overscan.
    [[nodiscard]] bool is_as_held() const {
        return holds_all() && width_px == spec.width && height_px == spec.height;
    }
};

/// Opens an image file, alpha not multiplied in where the format lets it. Throws core::Error
/// (where = `path`) for one that is missing, empty, cut off, no image or larger than 2^27 pixels.
[[nodiscard]] OpenFile open_image(const std::filesystem::path& path, const char* accepted);

/// The channels [begin, end) of all pixels of the image, as bytes, whole numbers or floats; 0 where
/// the file holds none. Throws core::Error if they cannot be read.
template <class T>
[[nodiscard]] std::vector<T> read_samples(OpenFile& file, int begin, int end) {
    const auto channels = static_cast<std::size_t>(end - begin);
    std::vector<T> held(static_cast<std::size_t>(file.spec.image_pixels()) * channels);
    constexpr auto kType = std::is_same_v<T, float>           ? OIIO::TypeDesc::FLOAT
                           : std::is_same_v<T, std::uint32_t> ? OIIO::TypeDesc::UINT32
                                                              : OIIO::TypeDesc::UINT8;
    const bool is_read = file.input->read_image(0, 0, begin, end, kType, held.data());
    // JPEG, TIFF and IFF that end too early are read for as far as they go; only a message tells.
    const std::string message = one_line(file.input->geterror());
    if (!is_read || !message.empty()) {
        throw core::Error(
            file.path,
            "the file is cut off or damaged" + (message.empty() ? "" : ": " + message),
            file.accepted);
    }
    if (file.is_as_held()) return held;
    std::vector<T> samples(static_cast<std::size_t>(file.width_px) *
                               static_cast<std::size_t>(file.height_px) * channels,
                           T{0});
    const int first_x = std::max(0, file.left_px);
    const int end_x = std::min(file.width_px, file.left_px + file.spec.width);
    for (int y = 0; y < file.height_px && first_x < end_x; ++y) {
        if (!file.holds(first_x, y)) continue;
        const auto at = [&](int x, int row, int width) {
            return static_cast<std::ptrdiff_t>(
                (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)) *
                channels);
        };
        const auto from =
            held.begin() + at(first_x - file.left_px, y - file.top_px, file.spec.width);
        std::copy(from,
                  from + at(end_x - first_x, 0, 0),
                  samples.begin() + at(first_x, y, file.width_px));
    }
    return samples;
}

}  // namespace ink::image_io
