#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/method_configs.h"
#include "harness/row.h"

namespace ink::report {

/// The rows of the study `compare` of a finished run in `folder`.
///
/// Throws core::Error (where = the folder or the file) for a folder that is not there or holds no
/// run, a run that is not finished or has no such row, and for one in which a method has several
/// settings on one view: charts have one marker a method.
[[nodiscard]] std::vector<harness::Row> rows_to_draw(const std::filesystem::path& folder);

/// Built-in scenes of `rows`, at most so many, at even distances in their order: those that can be
/// drawn anew without a file.
[[nodiscard]] std::vector<std::string> drawable_scenes(const std::vector<harness::Row>& rows,
                                                       std::size_t most);

/// The methods of `rows` with the settings they had there, baselines left out. Throws core::Error
/// for a method or a setting that this program does not know.
[[nodiscard]] std::vector<harness::MethodConfig> configs_of(const std::vector<harness::Row>& rows);

}  // namespace ink::report
