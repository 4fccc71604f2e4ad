#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ink::core {

/// A table as text: headings first, then a line each.
using Cells = std::vector<std::vector<std::string>>;

/// For a terminal: the first column to the left, the others to the right. Every line ends with a
/// line break; at least the headings are there.
[[nodiscard]] std::string aligned(const Cells& cells);

/// The same as a Markdown table.
[[nodiscard]] std::string markdown(const Cells& cells);

/// F, precision or recall as tables show it: ".912", "1.000"; "-" for nothing.
[[nodiscard]] std::string format_share(const std::optional<double>& share);

}  // namespace ink::core
