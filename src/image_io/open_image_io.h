#pragma once

/// The one door to OpenImageIO, for the sources of this room alone: no header that others include
/// comes through here.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <string>

namespace ink::image_io {

/// The first line of another library's message, short enough for one: what follows are
/// consequences.
[[nodiscard]] inline std::string one_line(std::string text) {
    text = text.substr(0, text.find('\n'));
    constexpr std::size_t kLongest = 160;
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

}  // namespace ink::image_io
