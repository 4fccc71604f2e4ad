#pragma once

#include <string>
#include <vector>

#include "experiment/summary/summary.h"
#include "harness/row.h"

namespace ink::report {

/// Milliseconds with three digits that count: "0.042", "3.10", "12.3", "1234"; "-" for nothing.
[[nodiscard]] std::string format_ms(const std::optional<double>& ms);

/// ".881-.932"; "-" for nothing.
[[nodiscard]] std::string format_range(const std::optional<statistics::Interval>& range);

/// The tables of a comparison for a terminal, at most 110 columns wide where names have up to 16
/// characters: a line per method, the baselines `none`, `sampled`, `exact_corner` and `oracle`
/// marked with a star; recalls per class, thresholds and tolerances below; what the words mean; and
/// one sentence that names the method with the lowest error, what it costs against the cheapest,
/// and whether its paired difference is significant.
///
/// `curves` give ODS, OIS and AP; without them those columns are left out. Ends without a line
/// break. No rows give the sentence alone.
[[nodiscard]] std::string verdict_table(const std::vector<harness::Row>& rows,
                                        const std::vector<statistics::CellCurve>& curves = {});

/// The same in Markdown, for a README, with the matrix of paired differences.
[[nodiscard]] std::string verdict_markdown(const std::vector<harness::Row>& rows,
                                           const std::vector<statistics::CellCurve>& curves = {});

/// "mote4 makes the fewest errors", or what else there is to say in as few words.
[[nodiscard]] std::string verdict_headline(const experiment::Verdict& verdict);

/// What follows "... makes the fewest errors: " in the sentence, plain text: the winner's F, what
/// it costs against the cheapest, whether its paired difference not significant, how many cells
/// failed.
[[nodiscard]] std::string verdict_details(const std::vector<harness::Row>& rows,
                                          const std::vector<experiment::MethodSummary>& summaries);

/// The sentence by itself, plain text.
[[nodiscard]] std::string verdict_sentence(const std::vector<harness::Row>& rows,
                                           const std::vector<experiment::MethodSummary>& summaries);

}  // namespace ink::report
