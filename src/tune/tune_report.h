#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tune/tune.h"

namespace ink::tune {

/// evaluations.csv, heading included (tune_folder.h has its columns).
[[nodiscard]] std::string evaluations_csv(const TuneResult& result, const TuneSpace& space);

/// What a preset says of how it came about.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> provenance_lines(
    const TuneResult& result, const TuneOptions& options);

/// What was gained where it searched, and on what it has not seen: "mine: F +.038 where it
/// searched, -.006 on knight: do not ship".
[[nodiscard]] std::string tune_finding(const TuneResult& result, const TuneOptions& options);

/// What came of a search, for a terminal: errors of the defaults, of what was found and of random
/// search on training and held-out scenes, the gap between them, intervals, the paired difference,
/// how the search came down, the settings.
[[nodiscard]] std::string tune_summary(const TuneResult& result, const TuneOptions& options);

}  // namespace ink::tune
