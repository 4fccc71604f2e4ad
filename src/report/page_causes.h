#pragma once

#include <string>
#include <vector>

#include "experiment/summary/cause_totals.h"

namespace ink::report {

/// What the colours of wrong pixels mean: a list of the causes of misses and one of those of false
/// lines.
[[nodiscard]] std::string cause_legend_html();

/// Pixels per method and cause as an HTML table: what is missing of the true pixels, and what is
/// off the lines of the drawn ones.
[[nodiscard]] std::string cause_table_html(const std::vector<experiment::CauseTotals>& totals);

}  // namespace ink::report
