#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/whole_file.h"

namespace ink::image_io {

/// Changes the display window of an OpenEXR file: its first and its last pixel.
inline void set_display_window(const std::filesystem::path& path,
                               const std::array<std::int32_t, 4>& corners) {
    std::string bytes = core::read_whole_file(path).value_or("");
    const std::string entry("displayWindow\0box2i\0", 20);
    const std::size_t at = bytes.find(entry);
    ASSERT_NE(at, std::string::npos);
    std::memcpy(bytes.data() + at + entry.size() + 4, corners.data(), sizeof corners);
    core::write_whole_file(path, bytes);
}

}  // namespace ink::image_io
