#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::score {

/// Whether an outline image has dark lines on light: more than three quarters of its pixels are 128
/// or lighter. Lines cover a small part of any image. An image of one value has no lines, and
/// is not taken for one; nor is an empty one.
[[nodiscard]] bool has_dark_lines(const core::Image<std::uint8_t>& image);

/// Each pixel v as 255 - v: dark lines as edge responses.
void invert(core::Image<std::uint8_t>& image);

}  // namespace ink::score
