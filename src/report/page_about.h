#pragma once

#include <string>

#include "report/report.h"

namespace ink::report {

/// What the numbers of the page mean, as HTML.
[[nodiscard]] std::string about_html();

/// Command, time, version, compiler, processor and libraries of the run, as an HTML list.
[[nodiscard]] std::string provenance_html(const ReportData& data);

}  // namespace ink::report
