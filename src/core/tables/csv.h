#pragma once

#include <string>

namespace ink::core {

/// A CSV field: quoted as RFC 4180 has it if it holds a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace ink::core
