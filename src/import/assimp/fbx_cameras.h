#pragma once

#include <set>
#include <string>
#include <string_view>

namespace ink::import {

/// The names of the nodes of an FBX file, text or binary, whose camera is orthographic. Assimp
/// takes these for cameras of perspective.
[[nodiscard]] std::set<std::string> read_fbx_parallel_cameras(std::string_view file);

}  // namespace ink::import
