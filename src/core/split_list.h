#pragma once

#include <string>
#include <vector>

namespace ink::core {

/// "a, b,c" as its parts without the blanks round them, empty ones left out.
[[nodiscard]] std::vector<std::string> split_list(const std::string& text);

}  // namespace ink::core
