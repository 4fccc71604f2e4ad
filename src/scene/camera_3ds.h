#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "scene/scene_stream.h"

namespace ink::scene {

/// The cameras of a .3ds file as its editor section places them, in the file's own z-up space.
///
/// Needed because Assimp 5.2 forgets where a camera looks as soon as the file has keyframes, and
/// takes its lens for an angle. The lens is a focal length f: the field of view is 2400 / f degrees
/// across (so write lib3ds and the file's own field-of-view tracks), made vertical here for the 4:3
/// pictures of its time. Up is the z axis, leant by the camera's roll. Damaged chunks end the
/// search: what was found until then is returned.
[[nodiscard]] std::vector<ImportedCamera> read_3ds_cameras(std::span<const std::byte> file);

/// The same of the file at `path`, turned and scaled as `world_from_file` turns the model.
[[nodiscard]] std::vector<ImportedCamera> read_3ds_cameras(const std::filesystem::path& path,
                                                           const glm::dmat4& world_from_file);

}  // namespace ink::scene
