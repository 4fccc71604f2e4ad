#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "import/scene_stream.h"

namespace ink::import {

/// The lights of a .3ds file that are not switched off, as its editor section has them, in the
/// file's own z-up space. Their strength is the multiplier, their ranges hold if the file says that
/// the light thins out.
///
/// Needed because Assimp 5.2 forgets ranges and keys. Damaged chunks end the search: what was found
/// until then is returned.
[[nodiscard]] std::vector<ImportedLight> read_3ds_lights(std::span<const std::byte> file);

/// The lights of the file at `path`, turned and scaled as the model is by the first node of
/// `motion`, its root. Those that the keyframer moves become nodes of `motion`, and what it lasts
/// grows to their last key, of place or colour. What of that is not heeded becomes a note.
[[nodiscard]] std::vector<ImportedLight> read_3ds_lights(const std::filesystem::path& path,
                                                         scene::Animation& motion,
                                                         std::vector<std::string>& notes);

}  // namespace ink::import
