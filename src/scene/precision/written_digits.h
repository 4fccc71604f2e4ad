#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh.h"
#include "scene/scene.h"

namespace ink::scene {

/// Half a unit of the last decimal place that the mesh's coordinates were written with, in object
/// space: what an exporter that prints four decimals may have taken from each.
///
/// Files keep no such number, and vertices are floats. So it is read off the floats: the smallest
/// number of decimals d for which every coordinate is the float nearest to a number of d decimals,
/// or the one beside. 0 where the coordinates have more digits than that, or where a float of the
/// largest coordinate's size cannot tell d decimals from more; and for a mesh without vertices.
/// O(vertices), and a few steps for a mesh with digits of all kinds.
[[nodiscard]] double written_rounding(const Mesh& mesh);

/// Topology::written_rounding_world of a scene with vertices at these places.
[[nodiscard]] std::vector<double> written_roundings(const Scene& scene,
                                                    std::span<const glm::dvec3> p_world);

}  // namespace ink::scene
