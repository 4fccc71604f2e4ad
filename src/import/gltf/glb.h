#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ink::import {

/// The bytes of a .glb (glTF 2.0, section 4.4): `json`, and `binary` as the chunk of its first
/// buffer, which is left out if it is empty. Throws core::Error (where = `path`) if they need more
/// than the 4 GiB that the format holds.
[[nodiscard]] std::string glb_bytes(std::string_view json,
                                    std::string_view binary,
                                    const std::filesystem::path& path);

}  // namespace ink::import
