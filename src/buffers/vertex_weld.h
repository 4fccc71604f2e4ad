#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace ink::buffers {

/// Which vertices of a model are one place.
struct VertexWeld {
    std::vector<std::uint32_t> place_of;  ///< per vertex
    std::vector<std::uint32_t> first_of;  ///< per place its first vertex: there the place lies
};

/// Joins each vertex to the first place that lies within `distance` of it, or makes it a place: as
/// a program of 2000 would while it reads a model. In this differs the exact truth's weld
/// (scene/topology.h), which joins over chains and does not depend on the order.
///
/// Distance 0 joins equal positions only, -0 being 0. O(n) expected. No points give an empty weld.
[[nodiscard]] VertexWeld weld_vertices(std::span<const glm::dvec3> points, double distance);

/// The triangles over places that have an area in `points`, in their order, with what was left out.
struct WeldedFaces {
    std::vector<scene::Triangle> faces;      ///< into VertexWeld::first_of
    std::vector<std::uint32_t> triangle_of;  ///< per face its triangle
    std::uint32_t degenerate = 0;            ///< two corners welded together, or collinear
    std::uint32_t duplicate = 0;             ///< the same three places again, in any order
};

/// What becomes of faces that are there twice.
enum class DoubleFaces { keep, drop };

[[nodiscard]] WeldedFaces weld_faces(const VertexWeld& weld,
                                     std::span<const glm::dvec3> points,
                                     std::span<const scene::Triangle> triangles,
                                     DoubleFaces double_faces);

}  // namespace ink::buffers
