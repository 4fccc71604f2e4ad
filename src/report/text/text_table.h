#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/text_table.h"
#include "experiment/summary/summary.h"

namespace ink::report {

/// A column of a table of methods: its heading and the text it holds for each.
struct TextColumn {
    std::string heading;
    std::function<std::string(const experiment::MethodSummary&)> text;
};

/// A column of F, precision or recall.
[[nodiscard]] TextColumn share_column(std::string heading,
                                      std::optional<double> experiment::MethodSummary::*field);

/// The method's name, whole, so that it can be copied; a baseline's with a star, that of a
/// method from outside with a plus.
[[nodiscard]] TextColumn name_column();

/// `columns` of `summaries`.
[[nodiscard]] core::Cells cells_of(const std::vector<TextColumn>& columns,
                                   const std::vector<experiment::MethodSummary>& summaries);

}  // namespace ink::report
