#pragma once

#include <span>
#include <vector>

#include "import/gltf/json.h"

namespace ink::import {

/// The bytes that a stream of EXT_meshopt_compression holds; `json` is that extension of a
/// bufferView.
[[nodiscard]] std::vector<std::byte> unpack_meshopt(std::span<const std::byte> packed,
                                                    const JsonObject& json);

}  // namespace ink::import
