#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "import/scene_stream.h"

namespace ink::import {

/// The text of a 3MF package's part, called without a slash in front. Throws Error if there is
/// none.
using PackageParts = std::function<std::string(const std::string& part)>;

/// 3MF: build items and nested components, each with its transform; objects in parts of their own.
/// Coordinates are in the unit of the package's first model, as they stand, and no digit is lost.
///
/// An instance is an object with a mesh in a build item. Supports, and build items of type "other",
/// which the core specification forbids, are left out with a note. Throws Refusal for extensions
/// that are required and change shapes, and for encrypted packages.
[[nodiscard]] ImportReply read_3mf(const std::filesystem::path& path);
/// The same of the model in the part `root`.
[[nodiscard]] ImportReply read_3mf_model(const PackageParts& parts, const std::string& root);

}  // namespace ink::import
