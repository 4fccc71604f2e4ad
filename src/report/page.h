#pragma once

#include <string>

#include "report/report.h"

namespace ink::report {

/// The whole report as one HTML page of at most about 20 MB: no file beside it, no network,
/// readable without its script. Every name in it is escaped.
[[nodiscard]] std::string report_page(const ReportData& data);

}  // namespace ink::report
