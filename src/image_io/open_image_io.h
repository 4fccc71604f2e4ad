#pragma once

/// The one door to OpenImageIO, for the sources of this room alone: no header that others include
/// comes through here.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>

namespace ink::image_io {

/// Another library's message on one line, short enough for one.
[[nodiscard]] inline std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    constexpr std::size_t kLongest = 160;
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

}  // namespace ink::image_io
