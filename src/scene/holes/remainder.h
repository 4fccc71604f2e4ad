#pragma once

#include <cstdint>
#include <span>

#include "scene/camera.h"
#include "scene/clusters.h"
#include "scene/surface.h"

namespace ink::scene {

/// Clusters of one solid: they are in a row.
[[nodiscard]] std::span<const Cluster> clusters_of(const Clusters& clusters, std::uint32_t solid);

/// Whether what lies of a solid outside all of the balls certainly hangs together, and is not
/// nothing. O(n log n).
///
/// A triangle leaves no piece outside a ball that does not hold one of its corners, since balls are
/// convex: so it is enough to join corners outside over triangles that meet no ball.
[[nodiscard]] bool hangs_together_outside(const Surface& moved,
                                          const Clusters& clusters,
                                          std::uint32_t solid,
                                          std::span<const Sphere> balls);

}  // namespace ink::scene
