#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/row.h"

namespace ink::report {

/// Milliseconds with three digits that count: "0.042", "3.10", "12.3", "1234"; "-" for nothing.
[[nodiscard]] std::string format_ms(const std::optional<double>& ms);

/// A comparison for a terminal: one table, at most 90 columns wide where names have up to 16
/// characters, with a line per method (baselines with a star, methods from outside with a plus);
/// one sentence that names the method with the lowest error, what it costs against the cheapest,
/// and whether its paired difference is significant; and warnings, a line each.
///
/// All else that is known of methods is on the page, and in summary.csv, differences.csv,
/// curves.csv, tolerances.csv and sweep.csv. Ends without a line break. No rows give the sentence
/// alone.
[[nodiscard]] std::string verdict_table(const std::vector<harness::Row>& rows);

/// The same in Markdown, for a README.
[[nodiscard]] std::string verdict_markdown(const std::vector<harness::Row>& rows);

}  // namespace ink::report
