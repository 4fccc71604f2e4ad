#pragma once

#include <string>

namespace ink::core {

/// Why the system refused, for a message: "disk full (no space left on device)" for ENOSPC, else
/// the system's words for `error` with a small first letter; "unknown reason" for 0.
[[nodiscard]] std::string system_reason(int error);

}  // namespace ink::core
