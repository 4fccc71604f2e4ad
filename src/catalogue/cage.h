#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "catalogue/shapes.h"
#include "scene/mesh.h"

// Smooth bodies from a coarse cage: limbs are pulled out of its faces, then it is subdivided. Only
// sums, products and square roots are used, so the mesh is the same on every machine.

namespace ink::catalogue {

/// A closed polyhedron of polygons, counter-clockwise seen from outside.
struct Cage {
    using Face = std::vector<std::uint32_t>;

    std::vector<glm::dvec3> points;
    std::vector<Face> faces;
};

/// The cage through `rings`, each of n points: n quads a band in the order of the points, band
/// after band, then the polygon over the first ring and the one over the last. Rings as in `loft`:
/// counter -clockwise seen from above and climbing.
[[nodiscard]] Cage cage_of_rings(std::span<const Ring> rings);

/// Pulls `face` out through `stations`: at each, the face's outline stands across the path, scaled
/// so that its corners lie `radius` from the station on average. The face keeps its number and ends
/// at the last station.
void pull(Cage& cage, std::size_t face, std::span<const TubeNode> stations);

/// The limit's approximation after `levels` >= 1 subdivisions (Catmull and Clark 1978, "Recursively
/// generated B-spline surfaces on arbitrary topological meshes"), each quad cut into two triangles.
[[nodiscard]] scene::Mesh subdivided(const Cage& cage, int levels);

}  // namespace ink::catalogue
