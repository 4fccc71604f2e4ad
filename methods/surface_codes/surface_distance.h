#pragma once

#include <cstdint>
#include <vector>

#include "methods/surface_codes/surface_graph.h"

namespace ink::methods {

/// Faces of one patch on either side of a crease that ends inside it, and how they were parted.
struct SlitCount {
    std::size_t edges = 0;   ///< creases with one patch on both sides, two steps apart by any way
    std::size_t parted = 0;  ///< of these, two whole steps or more apart
};

/// Makes ways steep round the ends of creases that are too short to be parted: there, and two faces
/// round, every way costs a whole step.
void steepen_short_slits(const SmoothMesh& mesh, SurfaceGraph& graph);

/// Per face how far it lies from an end of its patch, in units of kStep: from what lies farthest
/// from the patch's first face.
///
/// Across a crease inside a patch, where
/// the distance may be the same on both sides, one side is lifted: by as little as parts them by
/// two steps, and all round it by as much as its ways allow. In rounds, since what is lifted may
/// come level with something else; the round that parts most counts, and `rounds` 0 lifts nothing.
/// Between the ends of a way distances never differ by more than its cost.
[[nodiscard]] std::vector<std::int32_t> surface_distance(const SmoothMesh& mesh,
                                                         const SurfaceGraph& graph,
                                                         int rounds,
                                                         SlitCount* slits = nullptr);

}  // namespace ink::methods
