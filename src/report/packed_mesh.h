#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bake/coded_mesh.h"

namespace ink::report {

/// A mesh as live/mesh.js unpacks it.
struct PackedMesh {
    std::vector<std::uint8_t> bytes;  ///< deflated, in zlib's format
    std::size_t place_count = 0;      ///< points, and places of vertices that are at no point
};

/// The arrays of a mesh, and its vertices in the poses of a scene that moves.
///
/// Nothing is lost. Of each number stays what the one before it, or another array, does not tell;
/// the lowest bytes of all numbers of an array stand before the next ones.
[[nodiscard]] PackedMesh packed_mesh(const bake::CodedMesh& mesh,
                                     std::span<const bake::MovingVertices> poses);

}  // namespace ink::report
