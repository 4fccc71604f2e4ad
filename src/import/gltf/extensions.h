#pragma once

#include <string>
#include <vector>

#include "import/gltf/document.h"

namespace ink::import {

/// Throws Refusal, by name, if the file needs an extension that is not read. Notes those that it
/// uses, could be seen by, and are ignored.
void check_extensions(const GltfDocument& document, std::vector<std::string>& notes);

}  // namespace ink::import
