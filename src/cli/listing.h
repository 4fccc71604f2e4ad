#pragma once

#include <string>

namespace ink::cli {

/// What the program knows, as text for a terminal: "methods", "scenes", "params", "metrics"
/// (columns of rows.csv), "columns" (of every file of a run folder), "skips", "shadings", "axes" or
/// "all" (but the columns), with units, ranges and defaults; "" for another word.
[[nodiscard]] std::string listing(const std::string& what);

}  // namespace ink::cli
