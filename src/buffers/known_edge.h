#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace ink::buffers {

/// What an edge of a mesh is in one view.
enum class EdgeKind : std::uint8_t {
    none,      ///< between faces that run on into each other
    contour,   ///< what is on one side of it faces away, or is not there
    crease,    ///< between two faces that bend
    boundary,  ///< of one face
};

/// An edge that is a line from where the camera stands, hidden or not.
struct KnownEdge {
    glm::dvec3 a_world{0};
    glm::dvec3 b_world{0};
    EdgeKind kind = EdgeKind::none;
};

}  // namespace ink::buffers
