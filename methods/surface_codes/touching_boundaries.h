#pragma once

#include <cstdint>
#include <vector>

#include "buffers/surface_ids.h"
#include "scene/topology.h"

namespace ink::methods {

/// Two faces at an edge.
struct FacePair {
    std::uint32_t face0 = 0;
    std::uint32_t face1 = 0;
    std::uint32_t edge = 0;  ///< into Topology::edges
};

/// Pairs of faces of one object whose boundaries lie on each other without having both ends in
/// common, where the surface goes on flatter than a crease: the T-junctions of a mesh.
///
/// `edge` is that of the first face, on whose inside an end of the second face's edge lies, as near
/// as `options.weld_epsilon` has it (a share of the object's diagonal) and rounding can tell. Each
/// pair once, ascending. O(n log n) for n boundary edges that are alike in length.
[[nodiscard]] std::vector<FacePair> touching_boundaries(const scene::Topology& topology,
                                                        const buffers::PatchOptions& options);

}  // namespace ink::methods
