#pragma once

#include <filesystem>
#include <vector>

#include "harness/suite/suite.h"

namespace ink::experiment {

/// The models of a list: a TOML file whose [[model]] tables have `file` and `kind`, and
/// `split = "train"` where settings may be found on the model.
///
/// Tables of [[package]] may hold models too, as those of experiments/models.toml do. Other keys
/// are skipped: they say how a model is got. Throws core::Error (where = file and line) for a file
/// that cannot be read, one without models, a model without file or kind, another split, and a file
/// that is listed twice.
[[nodiscard]] std::vector<harness::ListedModel> read_model_list(const std::filesystem::path& path);

}  // namespace ink::experiment
