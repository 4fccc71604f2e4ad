#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "import/scene_stream.h"

namespace ink::import {

inline constexpr std::uint32_t kNone = ~0U;

/// A corner of a face: numbers of the file's positions, normals and texture coordinates, from 0.
struct ObjCorner {
    std::uint32_t position = 0;
    std::uint32_t normal = kNone;
    std::uint32_t texcoord = kNone;
    [[nodiscard]] bool operator==(const ObjCorner&) const = default;
};

/// Faces that follow each other, of one object and one material.
struct ObjRun {
    std::size_t first_face = 0;
    std::uint32_t object = 0;
    std::uint32_t material = 0;
};

/// What an OBJ file holds, in its order.
struct ObjContent {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;  ///< as ImportedMesh has them
    std::vector<ObjCorner> corners;
    std::vector<std::size_t> ends;  ///< face f has the corners from ends[f - 1] to ends[f]
    std::vector<ObjRun> runs;       ///< each ends where the next begins
    std::vector<std::string> objects;
};

/// A mesh for each object that has triangles, a part for each run of a material. Vertices come in
/// the order of their first use, each different corner once.
[[nodiscard]] std::vector<ImportedMesh> meshes_of(const ObjContent& content);

}  // namespace ink::import
