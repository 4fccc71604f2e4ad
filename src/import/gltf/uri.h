#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "import/gltf/json.h"

namespace ink::import {

/// Whether a URI carries its bytes itself ("data:...").
[[nodiscard]] bool is_data_uri(const std::string& uri);

/// The bytes in a data URI; only base64 is read. `owner` is complained of.
[[nodiscard]] std::vector<std::byte> bytes_of_data_uri(const std::string& uri,
                                                       const JsonObject& owner);

/// The file that a relative URI names, below `folder`: its percent-encoding is undone (RFC 3986).
/// `owner` is complained of where it names another computer, or leaves the folder.
[[nodiscard]] std::filesystem::path path_of_uri(const std::string& uri,
                                                const std::filesystem::path& folder,
                                                const JsonObject& owner);

}  // namespace ink::import
