#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ink::methods {

/// What an id tells apart.
enum class IdSource {
    object,  ///< the instance
    patch,   ///< faces joined over edges that bend by less than a crease, over objects too
    object_and_patch,  ///< the same within one object
    triangle,          ///< every face: a wireframe
};

/// What an id picture holds where nothing was drawn. No triangle has it.
inline constexpr std::uint32_t kNoId = 0xffffffffU;

/// One id per triangle of the scene, by global index; equal where `source` tells nothing apart.
///
/// Patches are numbered by their first triangles, so that a patch keeps its id while others change.
/// Only edges of two faces join, whichever way these are turned; `crease_rad` is 0..pi. A triangle
/// that welding dropped has the id of the one it repeats; one without area has its own, and covers
/// nothing. O(n log n); an empty scene has no ids.
[[nodiscard]] std::vector<std::uint32_t> surface_ids(const scene::Scene& scene,
                                                     IdSource source,
                                                     double crease_rad);

}  // namespace ink::methods
