#pragma once

#include <string>
#include <vector>

#include "lab/row.h"
#include "lab/summary.h"
#include "lab/sweep_summary.h"

namespace ink::lab {

/// Chance, thresholds (ODS, OIS, AP) and the ladder of tolerances as an HTML table with what the
/// words mean below; "" if there is nothing of it.
[[nodiscard]] std::string statistics_html(const std::vector<MethodSummary>& summaries);

/// The matrix of leads as an HTML table, those beyond chance in bold; "" with fewer than two
/// methods.
[[nodiscard]] std::string leads_html(const std::vector<Row>& rows);

/// The settings on each method's front, from the fastest to the best, as an HTML table; "" without
/// a sweep.
[[nodiscard]] std::string fronts_html(const Fronts& fronts);

}  // namespace ink::lab
