#pragma once

#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "experiment/summary/sweep_summary.h"
#include "harness/row.h"

namespace ink::report {

/// The random baseline, thresholds (ODS, OIS, AP) and the tolerance sweep as an HTML table with
/// what the words mean below; "" if there is nothing of it.
[[nodiscard]] std::string statistics_html(const std::vector<experiment::MethodSummary>& summaries);

/// The matrix of paired differences as an HTML table, significant ones in bold; "" with fewer than
/// two methods.
[[nodiscard]] std::string paired_differences_html(const std::vector<harness::Row>& rows);

/// The settings on each method's front, from the fastest to the best, as an HTML table; "" without
/// a sweep.
[[nodiscard]] std::string fronts_html(const experiment::Fronts& fronts);

}  // namespace ink::report
