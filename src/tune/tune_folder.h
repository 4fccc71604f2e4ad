#pragma once

#include <vector>

#include "core/tables/table.h"
#include "tune/tune.h"

namespace ink::tune {

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
