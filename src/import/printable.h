#pragma once

#include <cstddef>
#include <string>

namespace ink::import {

/// Foreign text as one line of printable UTF-8, shortened to `most` bytes; what is none becomes
/// '?'.
[[nodiscard]] std::string printable(const std::string& text, std::size_t most);

}  // namespace ink::import
