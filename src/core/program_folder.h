#pragma once

#include <filesystem>

namespace ink::core {

/// The folder of the running program; "" if the system does not tell.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace ink::core
