#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/tables/table.h"
#include "tune/tune.h"

namespace ink::tune {

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

/// evaluations.csv: a line per evaluation of a search.
[[nodiscard]] core::TableInfo evaluations_table(const TuneSpace& space);

/// Takes `options.out` for a search: refuses it with core::Error (where = the folder) if it holds
/// another run, unless `options.is_forced`, which throws that away; then writes run.toml, which
/// says that the search is not finished, and what there is to say of the models in `scenes`.
void begin_folder(const TuneOptions& options,
                  const TuneSpace& space,
                  const std::vector<harness::SceneViews>& scenes);

/// Writes what came of a search into `options.out`, as every run folder has it: rows.csv with a
/// line per scene for the method as it was, as it was tuned and at random search's best,
/// evaluations.csv, methods.csv, and run.toml, which then says that it is finished.
void finish_folder(const TuneResult& result, const TuneOptions& options, const TuneSpace& space);

}  // namespace ink::tune
