#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "import/scene_stream.h"
#include "scene/mesh.h"

namespace ink::import {

/// The faces of a file, of any number of corners, until all vertices are known.
struct Polygons {
    std::vector<std::uint32_t> corners;
    std::vector<std::size_t> ends;  ///< face f has the corners from ends[f - 1] to ends[f]
};

/// The triangles of faces, in order and turned as they are. A face of n corners gives n - 2; one of
/// fewer than three gives none.
///
/// A face without a dent is a fan from its first corner; a quad with one is a fan from there. Of
/// other faces ears are cut: corners that stick out and whose triangle holds no other corner, seen
/// along the face's own normal. What crosses itself is cut up somehow.
[[nodiscard]] std::vector<scene::Triangle> triangles_of(const Polygons& polygons,
                                                        const std::vector<glm::dvec3>& positions);

/// How many faces have fewer than three corners.
[[nodiscard]] std::size_t count_without_area(const Polygons& polygons);

/// The reply for a file that is one object: `mesh` without triangles yet, made of `faces`. Faces
/// without three corners are left out with a note.
[[nodiscard]] ImportReply reply_of_mesh(ImportedMesh mesh, const Polygons& faces);

/// What is said of materials that let light through.
[[nodiscard]] std::string drawn_opaque(std::size_t materials);

/// "1 line", "2 lines".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

}  // namespace ink::import
