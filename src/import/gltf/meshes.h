#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/primitive.h"
#include "import/scene_stream.h"
#include "scene/animation.h"

namespace ink::import {

/// A mesh of the file: its primitives of triangles, one part each, vertices in their order.
struct GltfMesh {
    ImportedMesh mesh;                          ///< without any target's share
    std::vector<scene::Morph::Target> targets;  ///< at the mesh's own weights
    bool has_bones = false;
    std::vector<std::vector<scene::BoneWeight>> influences;  ///< per vertex, if it has bones
    std::size_t lines_left_out = 0;                          ///< primitives of points or lines
    std::size_t empty_parts = 0;  ///< primitives of triangles that have none
};

/// Reads meshes of a document. Borrows what it is given.
class GltfMeshReader {
  public:
    GltfMeshReader(const GltfDocument& document, GltfBuffers& buffers, GltfAccessors& accessors)
        : document_(document), buffers_(buffers), accessors_(accessors) {}

    /// With influences only if the mesh is to have bones; then every part must have some.
    [[nodiscard]] GltfMesh read_mesh(std::size_t index, bool has_bones);

  private:
    void add_primitive(const JsonObject& primitive, std::uint32_t number, GltfMesh& to);
    void add_vertices(const JsonObject& primitive,
                      GltfPrimitive& attributes,
                      const std::vector<double>& p,
                      GltfMesh& to);
    [[nodiscard]] std::optional<std::uint32_t> shared_vertices(const JsonObject& primitive,
                                                               std::size_t position) const;
    void add_influences(GltfPrimitive& attributes, GltfMesh& to);
    void add_marks(const JsonObject& primitive, std::size_t first_triangle, ImportedMesh& to);
    void add_targets(const JsonObject& primitive, std::size_t vertices, GltfMesh& to);

    const GltfDocument& document_;
    GltfBuffers& buffers_;
    GltfAccessors& accessors_;
    /// The mesh's primitives so far and their first vertices, by the accessor of their positions.
    std::multimap<std::size_t, std::pair<JsonObject, std::uint32_t>> added_;
};

}  // namespace ink::import
