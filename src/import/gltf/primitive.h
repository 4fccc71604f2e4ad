#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/draco_mesh.h"
#include "scene/mesh.h"

namespace ink::import {

/// What packs a whole primitive.
inline constexpr const char* kDracoMesh = "KHR_draco_mesh_compression";

/// The extension that says which edges a renderer draws (Khronos, glTF, extensions/2.0/Vendor).
inline constexpr const char* kEdgeVisibility = "EXT_mesh_primitive_edge_visibility";

/// The numbers of its bit field.
enum EdgeVisibility : std::uint8_t { kHidden, kSilhouette, kHard, kHardAgain };

/// Whether a primitive is of triangles (mode 4), a strip of them (5) or a fan (6).
[[nodiscard]] bool is_of_triangles(const JsonObject& primitive);

/// One primitive of triangles, from its accessors or from Draco's stream. Borrows what it is given.
class GltfPrimitive {
  public:
    GltfPrimitive(const GltfDocument& document,
                  GltfBuffers& buffers,
                  GltfAccessors& accessors,
                  const JsonObject& primitive);

    [[nodiscard]] const JsonObject& json() const { return json_; }
    [[nodiscard]] const JsonObject& attributes() const { return attributes_; }
    [[nodiscard]] bool has(const char* name) const { return attributes_.has(name); }
    [[nodiscard]] std::size_t accessor(const char* name) const {
        return attributes_.index(name, accessors_.size());
    }
    /// Of POSITION; 0 if there is none.
    [[nodiscard]] std::size_t vertices() const { return vertices_; }
    [[nodiscard]] bool is_packed() const { return packed_.has_value(); }

    /// All components of all elements of an attribute, one behind the other.
    [[nodiscard]] std::vector<double> numbers(const char* name,
                                              const AccessorRule& rule,
                                              std::size_t width);
    /// The same as they stand, of any type: see GltfAccessors::components.
    [[nodiscard]] std::vector<double> components(const char* name);
    /// Three vertices for each triangle, in the order of the file (glTF 2.0, section 3.7.2.1).
    [[nodiscard]] std::vector<scene::Triangle> triangles();

  private:
    [[nodiscard]] bool is_packed(const char* name) const;
    [[nodiscard]] std::vector<double> unpacked(const char* name, std::size_t width) const;
    void check_count(const char* name, std::size_t elements) const;
    [[nodiscard]] std::vector<std::uint32_t> corners();

    GltfAccessors& accessors_;
    JsonObject json_;
    JsonObject attributes_;
    std::optional<JsonObject> packed_json_;
    std::optional<DracoMesh> packed_;
    std::size_t vertices_ = 0;
};

}  // namespace ink::import
