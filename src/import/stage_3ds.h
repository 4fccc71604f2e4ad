#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "import/scene_stream.h"

namespace ink::import {

/// The cameras of a .3ds file as its editor section places them, in the file's own z-up space.
///
/// Needed because Assimp 5.2 forgets where a camera looks as soon as the file has keyframes, and
/// takes its lens for an angle. The lens is a focal length f: the field of view is 2400 / f degrees
/// across (so write lib3ds and the file's own field-of-view tracks), made vertical here for the 4:3
/// images of its time. Up is the z axis, leant by the camera's roll. Damaged chunks end the
/// search: what was found until then is returned.
[[nodiscard]] std::vector<ImportedCamera> read_3ds_cameras(std::span<const std::byte> file);

/// When a camera's eye and target are where, file space, seconds.
struct CameraKeys {
    std::string name;
    std::vector<scene::VectorKey> eye;
    std::vector<scene::VectorKey> target;
};

/// The keys of a .3ds file's keyframer section, a camera each, in the file's order; keys of one
/// list are in order of time. What eases in and out of a key (tension, continuity, bias) is passed
/// over, tracks of roll and lens too, and cameras whose eye or target hangs on an object. Damage
/// ends the search, a key that goes back in time its list.
[[nodiscard]] std::vector<CameraKeys> read_3ds_camera_keys(std::span<const std::byte> file);

/// The cameras of the file at `path`, turned and scaled as the model is by the first node of
/// `motion`, its root. Eyes and targets that have more than one key become nodes of `motion`, and
/// what it lasts grows to their last key.
[[nodiscard]] std::vector<ImportedCamera> read_3ds_cameras(const std::filesystem::path& path,
                                                           scene::Animation& motion);

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
