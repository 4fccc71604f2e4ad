#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bake/gltf_edit.h"
#include "import/gltf/primitive.h"
#include "import/import.h"

namespace ink::bake {

/// A primitive of the file and the triangles of the scene that it is.
struct BakedPrimitive {
    std::size_t mesh = 0;    ///< of the file
    std::size_t number = 0;  ///< in the mesh
    /// The global index of its first triangle, in the first instance of its mesh; the others follow
    /// in the order of the file.
    std::size_t first_triangle = 0;
    import::GltfPrimitive source;
    std::vector<scene::Triangle> triangles;  ///< vertices, as the baked file has them
    /// Per triangle by how many corners it was turned: its corner i was corner (i + turn) % 3.
    std::vector<std::uint8_t> turns;

    /// "mesh 2, primitive 0", for messages.
    [[nodiscard]] std::string place() const;
    /// Its JSON in the baked file.
    [[nodiscard]] Json& json(GltfEdit& edit) const;
};

/// The primitives of a file, by mesh and number, and what has none.
struct BakedPrimitives {
    std::vector<BakedPrimitive> list;  ///< by first_triangle
    std::size_t repeated_meshes = 0;   ///< which several instances share
    std::size_t absent_meshes = 0;     ///< which have triangles and are in no scene
};

/// Where the triangles of an imported glTF file stand in its document. Throws core::Error if they
/// are not the same, which is so if the file was changed meanwhile.
[[nodiscard]] BakedPrimitives find_primitives(GltfEdit& edit, const import::ImportedModel& model);

}  // namespace ink::bake
