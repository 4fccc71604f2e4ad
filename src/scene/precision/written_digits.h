#pragma once

#include <cstdint>
#include <vector>

#include "scene/mesh.h"
#include "scene/scene.h"
#include "scene/topology.h"

namespace ink::scene {

/// Half a unit of the last decimal place that the mesh's coordinates were written with, in object
/// space: what an exporter that prints four decimals may have taken from each.
///
/// Files keep no such number, and vertices are floats. So it is read off the floats: the smallest
/// number of decimals d for which every coordinate is the float nearest to a number of d decimals,
/// or the one beside. 0 where the coordinates have more digits than that, or where a float of the
/// largest coordinate's size cannot tell d decimals from more; and for a mesh without vertices.
/// O(vertices), and a few steps for a mesh with digits of all kinds.
[[nodiscard]] double written_rounding(const Mesh& mesh);

/// How far a rounding of each coordinate by at most `rounding` may have moved a vertex once the
/// instance is placed, world units.
[[nodiscard]] double most_moved_world(const Instance& instance, double rounding);

/// Gathers, while a scene is welded, what the digits of its meshes may have moved each vertex by.
class WrittenRoundings {
  public:
    explicit WrittenRoundings(const Scene& scene);

    /// How far the digits of its mesh may have moved a vertex of the instance, world units.
    [[nodiscard]] double of(const Instance& instance) const;
    /// Notes that of a vertex of the welded scene; the most counts.
    void note(std::uint32_t vertex, double written_world);
    /// Topology::written_rounding_world, from the places and roundings of the vertices.
    [[nodiscard]] std::vector<double> per_vertex(const Topology& topology) const;

  private:
    std::vector<double> of_mesh_;
    std::vector<double> of_vertex_;  ///< up to the last that has some
};

}  // namespace ink::scene
