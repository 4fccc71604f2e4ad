#pragma once

#include <filesystem>

namespace ink::import {

/// Throws core::Error if a file is shorter than its own header says. Knows 3DS, binary glTF, MD2
/// and MD3, whose readers may stop early and say nothing.
void check_length(const std::filesystem::path& path);

}  // namespace ink::import
