#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

/// A file called `name` that holds `bytes`, in a folder of this process, for readers that take
/// paths. It is written over by the next call of that name; the folder is removed at the end.
[[nodiscard]] std::filesystem::path scratch_file(const std::string& name, Bytes bytes);

}  // namespace ink::fuzz
