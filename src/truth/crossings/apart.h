#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/topology.h"

namespace ink::truth {

/// A triangle laid out for the quick tests, and its index among the faces.
struct Flat {
    std::array<glm::dvec3, 3> p;
    glm::dvec3 normal;    ///< cross product of two sides
    double size = 0;      ///< largest component of its sides
    double rounding = 0;  ///< the most of its vertices, world units
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t face = 0;
};

/// The triangle of a face.
[[nodiscard]] Flat flat(const scene::Topology& topology, std::uint32_t f);

/// Whether two triangles whose boxes touch certainly have nothing in common but what they share,
/// though rounding may have moved them.
[[nodiscard]] bool is_apart(const Flat& f, const Flat& g);

}  // namespace ink::truth
