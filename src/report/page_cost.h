#pragma once

#include <string>

#include "report/report.h"

namespace ink::report {

/// The section on cost as HTML: what each method declares beside what it took and what the model
/// predicted, the prices that were fitted, and scaling_html. "" if there is nothing of it.
[[nodiscard]] std::string cost_html(const ReportData& data);

/// What that section shows, in a few plain sentences.
[[nodiscard]] std::string_view cost_intro();

/// Times against triangles, pixels and covered share: a sentence whether any step is worse than
/// linear, a chart per axis, the exponents as a table, as HTML; "" if it was not measured.
[[nodiscard]] std::string scaling_html(const ReportData& data);

}  // namespace ink::report
