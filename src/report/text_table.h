#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiment/summary.h"

namespace ink::report {

/// A column of a table of methods: its heading and the text it holds for each.
struct TextColumn {
    std::string heading;
    std::function<std::string(const experiment::MethodSummary&)> text;
};

/// A column of F, precision or recall.
[[nodiscard]] TextColumn share_column(std::string heading,
                                      std::optional<double> experiment::MethodSummary::*field);

/// The method's name, a bracket's with a star; cut to 16 characters, so that a table keeps its
/// width whatever methods are called.
[[nodiscard]] TextColumn name_column();

/// A table as text: headings first, then a line each.
using core::Cells = std::vector<std::vector<std::string>>;

/// `columns` of `summaries`.
[[nodiscard]] core::Cells cells_of(const std::vector<TextColumn>& columns,
                                   const std::vector<experiment::MethodSummary>& summaries);

/// For a terminal: the first column to the left, the others to the right. Every line ends with a
/// line break; at least the headings are there.
[[nodiscard]] std::string aligned(const core::Cells& cells);

/// The same as a Markdown table.
[[nodiscard]] std::string markdown(const core::Cells& cells);

}  // namespace ink::report
