#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "import/gltf/json.h"

namespace draco {
class Mesh;
}

namespace ink::import {

/// A primitive that KHR_draco_mesh_compression holds, by libdraco.
class DracoMesh {
  public:
    /// `json` is the extension, for messages.
    DracoMesh(std::span<const std::byte> packed, const JsonObject& json);

    [[nodiscard]] std::size_t vertex_count() const;
    /// Three per triangle, each below vertex_count.
    [[nodiscard]] std::vector<std::uint32_t> indices() const;
    /// All components of the attribute with the id `unique_id`, `width` for each vertex: integers
    /// as they stand.
    [[nodiscard]] std::vector<double> numbers(std::uint32_t unique_id, std::size_t width) const;

  private:
    JsonObject json_;
    std::shared_ptr<const draco::Mesh> mesh_;
};

}  // namespace ink::import
