#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/topology.h"

namespace ink::scene {

/// An edge bent by less is taken for flat: more than rounding bends the diagonal of a planar quad,
/// less than any eye could see.
inline constexpr double kFlat_rad = 1e-3;

/// What can be reached over welded edges, objects notwithstanding.
struct Piece {
    std::size_t faces = 0;
    glm::dvec3 low_world{0};  ///< the box round it
    glm::dvec3 high_world{0};
    double radius = 0;           ///< from the box's centre to its farthest corner
    bool is_closed = false;      ///< each of its edges has exactly two faces
    bool is_consistent = false;  ///< neighbours run through their edge in opposite directions
    bool is_sealed = false;      ///< both, and turned outwards: its signed volume is positive
    /// Sealed, a ball by Euler's count, and bent outwards at every edge that is not flat: it cannot
    /// hide a part of its own front. A star that winds round itself twice would be taken for one.
    bool is_convex = false;
};

/// The pieces of a welded scene, in the order in which its faces meet them.
struct Pieces {
    std::vector<Piece> pieces;
    std::vector<std::uint32_t> piece_of;  ///< per face
};

/// Cuts a welded scene into its pieces. O(n log n).
[[nodiscard]] Pieces find_pieces(const Topology& topology);

/// The number of pairs of pieces whose boxes share a volume, or an area where one of them is flat,
/// and whose balls overlap: only those can pierce each other. Mere touching does not count.
/// Counting ends at `most`.
[[nodiscard]] std::size_t count_overlapping_pieces(const std::vector<Piece>& pieces,
                                                   std::size_t most);

}  // namespace ink::scene
