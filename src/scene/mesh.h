#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ink::scene {

/// The three vertex indices of a triangle, counter-clockwise seen from its front.
using Triangle = std::array<std::uint32_t, 3>;

/// Indexed triangles in object space, as the file or the catalogue gave them: nothing repaired.
///
/// Invariant (checked by `check_scene`): every index is below `positions.size()`, all floats
/// finite.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  ///< object space
    std::vector<glm::vec3> normals;    ///< object space, unit; empty, or one per position
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> materials;  ///< empty (all material 0), or one per triangle
    /// How far the file's own numbers may have been rounded, object space, where that is more than
    /// half a unit in the last place of `positions`.
    double rounding = 0;
    /// Which sides its file marks as lines: empty where it marks none, or a byte per triangle in
    /// which bit i is the side from corner i to the next.
    std::vector<std::uint8_t> marked_sides = {};
};

}  // namespace ink::scene
