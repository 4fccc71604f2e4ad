#pragma once

#include <filesystem>

namespace ink::import {

/// Throws Refusal, which names its format, for a file of a kind that is known and not read, such as
/// STEP: by its first bytes where the kind has a mark, else by the file's ending.
void refuse_other_format(const std::filesystem::path& path);

}  // namespace ink::import
