#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "import/fbx/document.h"
#include "import/scene_stream.h"

namespace ink::import {

/// The control points of a geometry. Throws core::Error unless they are whole.
[[nodiscard]] std::vector<glm::dvec3> points_of(const FbxObject& geometry);

/// A geometry's polygons on their way into a mesh: a vertex for each corner.
struct FbxCorners {
    std::vector<std::uint32_t> points;   ///< per corner
    std::vector<std::size_t> ends;       ///< polygon p has the corners from ends[p - 1] to ends[p]
    std::vector<std::size_t> materials;  ///< per polygon, a slot of the model's
};

/// Throws core::Error for corners that are damaged, Refusal for polygons that are holes.
[[nodiscard]] FbxCorners corners_of(const FbxObject& geometry, std::size_t points);

/// The file's normals, one a corner; empty without any that fit.
[[nodiscard]] std::vector<glm::dvec3> normals_of(const FbxObject& geometry,
                                                 const FbxCorners& corners);

/// Appends the polygons that have three corners, by material in the order in which these come, with
/// `positions` and `normals` a corner; slot s is material `numbers[s]`, or `none`.
/// Returns how many polygons have fewer.
std::size_t append_polygons(const FbxCorners& corners,
                            const std::vector<glm::dvec3>& positions,
                            const std::vector<std::uint32_t>& numbers,
                            std::uint32_t none,
                            ImportedMesh& mesh);

}  // namespace ink::import
