#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "methods/mesh_lookup/lookup_table.h"
#include "scene/prepared_scene.h"

namespace ink::bake {

/// What moves of a mesh.
struct MovingVertices {
    std::vector<glm::vec3> p_world;
    std::vector<glm::vec3> n_world;  ///< unit, over smooth patches: creases from 40 degrees part
    std::vector<glm::vec3> hull_n_world;  ///< unit, over all faces round a vertex, as hulls grow
};

/// A scene as one mesh in world space that a GPU draws with the methods' shaders: what they read is
/// there per vertex, at default parameters of the methods.
///
/// Of every triangle the first and the last vertex carry its codes (flat_codes.h). Vertices are
/// numbered as triangles come to them.
struct CodedMesh : MovingVertices {
    std::vector<std::uint32_t> indices;  ///< 3 a triangle, in the order of global indices
    std::vector<std::uint32_t> corners;  ///< per vertex one that it is of: 3 global index + 0..2
    std::vector<std::uint8_t> surface8;  ///< code, 2..255
    std::vector<std::uint8_t> label8;    ///< label, 1..255
    std::vector<std::uint32_t> id;       ///< of the patch within its object, as `ids` draws it
    methods::LookupTable lookup;         ///< faces and their neighbours, with vertices of its own
    std::size_t added_count = 0;         ///< vertices that only codes made necessary

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
    [[nodiscard]] std::size_t vertex_count() const { return p_world.size(); }
};

/// An empty scene has no triangles. Throws core::Error as flat_codes() does.
[[nodiscard]] CodedMesh coded_mesh(const scene::PreparedScene& scene);

/// The vertices of the mesh of a scene, in another pose of that scene.
[[nodiscard]] MovingVertices posed_vertices(const CodedMesh& mesh,
                                            const scene::PreparedScene& posed);

}  // namespace ink::bake
