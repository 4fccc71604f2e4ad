#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"
#include "scene/topology.h"

namespace ink::scene {

/// Where a method's normals come from (section 3 of the design).
enum class NormalSource {
    file,   ///< the file's; a mesh without any gets `patch`
    patch,  ///< per corner, averaged over the smooth patch it lies in; the default of comparisons
    facet,  ///< one per triangle
};

/// The scene flattened for drawing: world-space corners, shared where position and normal are
/// equal.
///
/// `triangles[g]` is the triangle with global index g, degenerate ones included, so that ids agree.
struct Surface {
    std::vector<glm::dvec3> p_world;
    std::vector<glm::vec3> n_world;  ///< unit, one per p_world; empty if not asked for
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> object;  ///< instance index per triangle
};

/// The drawn surface without normals.
[[nodiscard]] Surface flatten(const Scene& scene);

/// The drawn surface with normals from `source`.
///
/// A patch is what can be reached round a vertex over edges of two faces that bend by less than
/// `crease_rad`; its normal there is the corner-angle-weighted mean of its faces' normals (Max 1999
/// and earlier practice). Faces of opposite orientation are not joined. A degenerate triangle gets
/// the normal (0, 0, 1): it covers no pixel.
[[nodiscard]] Surface flatten(const Scene& scene, NormalSource source, double crease_rad);

}  // namespace ink::scene
