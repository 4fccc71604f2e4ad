#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/disjoint_sets.h"

namespace ink::scene {

/// Joins points that lie close to each other.
///
/// `add` links every two points of one part that are no farther apart than `distance`; points that
/// are linked, over however many others, belong together. So the outcome depends neither on the
/// order of the points nor on that of the parts, and a chain of short steps joins from end to end.
class NearPoints {
  public:
    /// `points` stay where they are as long as this lives.
    explicit NearPoints(std::span<const glm::dvec3> points);

    /// Links the points of one part, given by their indices, each once. O(n log n) while only few
    /// share a cube of side `distance`. Distance 0 links nothing.
    void add(std::span<const std::uint32_t> part, double distance);

    /// Per point the position of its group: of all its points the first by x, then y, then z.
    [[nodiscard]] std::vector<glm::dvec3> representatives();

  private:
    std::span<const glm::dvec3> points_;
    core::DisjointSets sets_;
};

}  // namespace ink::scene
