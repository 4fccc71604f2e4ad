#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/entrants.h"
#include "harness/row.h"

namespace ink::report {

/// The rows of a finished run: `folder`/rows.csv.
///
/// Throws core::Error (where = the folder or the file) for a folder that is not there, one without
/// rows.csv, a run that is not finished (rows.csv.part), a table that is not one of rows or has
/// none, and for a run in which a method has several settings on one view: charts have one marker a
/// method.
[[nodiscard]] std::vector<harness::Row> read_run(const std::filesystem::path& folder);

/// Built-in scenes of `rows`, at most so many, at even distances in their order: those that can be
/// drawn anew without a file.
[[nodiscard]] std::vector<std::string> drawable_scenes(const std::vector<harness::Row>& rows,
                                                       std::size_t most);

/// The methods of `rows` with the settings they had there, brackets left out. Throws core::Error
/// for a method or a setting that this program does not know.
[[nodiscard]] std::vector<harness::Entrant> entrants_of(const std::vector<harness::Row>& rows);

}  // namespace ink::report
