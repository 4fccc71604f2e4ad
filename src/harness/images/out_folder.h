#pragma once

#include <filesystem>

namespace ink::harness {

/// Makes the folder that results go to, with those above it; one that is there is left alone. Asked
/// before any work. Throws core::Error (where = the folder) if it cannot be made.
void make_out_folder(const std::filesystem::path& folder);

}  // namespace ink::harness
