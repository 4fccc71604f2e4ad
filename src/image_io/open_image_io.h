#pragma once

/// The one door to OpenImageIO, for the sources of this room alone: no header that others include
/// comes through here.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.h"

namespace ink::image_io {

/// The first line of another library's message, short enough for one: what follows are
/// consequences.
[[nodiscard]] inline std::string one_line(std::string text) {
    text = text.substr(0, text.find('\n'));
    constexpr std::size_t kLongest = 160;
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

/// A file that was opened, and what its library says of it.
struct OpenFile {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    std::string path;
    const char* accepted = "";  ///< for messages
};

/// Opens an image file, alpha not multiplied in where the format lets it. Throws core::Error
/// (where = `path`) for one that is missing, empty, cut off, no image or larger than 2^27 pixels.
[[nodiscard]] OpenFile open_image(const std::filesystem::path& path, const char* accepted);

/// The channels [begin, end) of all pixels, as bytes or floats. Throws core::Error if they cannot
/// be read.
template <class T>
[[nodiscard]] std::vector<T> read_samples(OpenFile& file, int begin, int end) {
    std::vector<T> samples(static_cast<std::size_t>(file.spec.image_pixels()) *
                           static_cast<std::size_t>(end - begin));
    constexpr auto kType = std::is_same_v<T, float> ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!file.input->read_image(0, 0, begin, end, kType, samples.data())) {
        throw core::Error(
            file.path, "cannot be read: " + one_line(file.input->geterror()), file.accepted);
    }
    return samples;
}

}  // namespace ink::image_io
