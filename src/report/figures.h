#pragma once

#include <filesystem>
#include <vector>

#include "report/report.h"

namespace ink::report {

/// Writes the figures of a comparison into `folder` (which exists): `figures/<scene>.png`, a strip
/// of truth and methods with the errors in colour, per shown view; `figures/overview.png`, at
/// most eight strips below each other, taken evenly from all; `figures/fronts.svg`, error against
/// time; `figures/classes.svg`, recall per class; `figures/causes.svg`, where the error goes;
/// `figures/cancellation.svg`, predicted against measured misses.
///
/// Each file appears whole or not at all; of a run before, files of other names stay. Throws
/// core::Error if one cannot be written. Without views there are no strips.
void write_figures(const ReportData& data, const std::filesystem::path& folder);

/// A scene's name as part of a file name: letters, digits, `.`, `_` and `-` stay, the rest becomes
/// `_`; never empty, hidden, or longer than 80 characters.
[[nodiscard]] std::string file_stem(const std::string& scene);

}  // namespace ink::report
