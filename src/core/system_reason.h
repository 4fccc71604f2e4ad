#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace ink::core {

/// Why the system refused, for a message: "disk full (no space left on device)" for ENOSPC, else
/// the system's words for `error` with a small first letter; "unknown reason" for 0.
[[nodiscard]] std::string system_reason(int error);

/// A path that the file system refused to look up, to read or to write, as bad input.
[[nodiscard]] Error refused_path(const std::filesystem::filesystem_error& error);

}  // namespace ink::core
