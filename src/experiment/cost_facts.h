#pragma once

#include <string>

#include "harness/row.h"

namespace ink::experiment {

/// Where the cost facts of a table's rows are kept while an experiment runs: they are no columns,
/// but the cost model needs them when all rows are there.
[[nodiscard]] std::string facts_table(const std::string& table);

/// The facts of a row as numbers in one line without its line break; "" if it has none.
[[nodiscard]] std::string cost_facts_line(const harness::Row& row);

/// What cost_facts_line wrote; nothing for "". Throws core::Error (where = `where`) for other text.
[[nodiscard]] std::optional<harness::CostFacts> read_cost_facts(const std::string& line,
                                                                const std::string& where);

}  // namespace ink::experiment
