#pragma once

#include <string>
#include <vector>

#include "core/tables/table.h"

namespace ink::experiment {

/// evaluations.csv of a tuner that searches parameters of these names.
[[nodiscard]] core::TableInfo evaluations_table(const std::vector<std::string>& searched);

/// Every table that a run folder may hold, and its run.toml (whose keys stand as columns), in the
/// order in which a reader meets them.
[[nodiscard]] std::vector<core::TableInfo> dictionary();

/// The data dictionary as Markdown: experiments/columns.md.
[[nodiscard]] std::string dictionary_markdown();

/// The same for a terminal: a line per column under its table.
[[nodiscard]] std::string dictionary_text();

}  // namespace ink::experiment
