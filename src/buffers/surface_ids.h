#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ink::buffers {

/// What an id tells apart.
enum class IdSource {
    object,  ///< the instance
    patch,   ///< faces joined over edges that bend by less than a crease, over objects too
    object_and_patch,  ///< the same within one object
    triangle,          ///< every face: a wireframe
};

/// What an id image holds where nothing was drawn. No triangle has it.
inline constexpr std::uint32_t kNoId = 0xffffffffU;

/// What makes patches of faces.
struct PatchOptions {
    double crease_rad = 0;  ///< dihedral deviation from which on an edge parts two patches, 0..pi
    /// How near vertices of one object must lie to be one, as a share of its diagonal; 0: at the
    /// same place only. What that makes flat, or alike, has ids of its own.
    double weld_epsilon = 0;
};

/// One id per triangle of the scene, by global index; equal where `source` tells nothing apart.
///
/// Patches are numbered by their first triangles, so that a patch keeps its id while others change.
/// Only edges of two faces join, whichever way these are turned. A triangle that repeats another
/// has the id of that one; one without area has its own, and covers nothing. O(n log n); an empty
/// scene has no ids.
[[nodiscard]] std::vector<std::uint32_t> surface_ids(const scene::Scene& scene,
                                                     IdSource source,
                                                     const PatchOptions& options);

}  // namespace ink::buffers
