#pragma once

#include <cstdint>

#include "crosscheck/mesh_walk.h"
#include "scene/precision/rounding.h"

namespace ink::crosscheck::walking {

// How an edge that was met lies to what is seen beside it: by heights over planes and distances in
// the world, which rounding bounds, and by exact signs where the eye lies in a plane with both.

/// The mesh edge that was met.
[[nodiscard]] std::uint32_t edge_of(const ClipMesh& mesh, const MetEdge& met);

/// A point of an edge that was met on the way.
[[nodiscard]] scene::RoundedPoint point_of(const ClipMesh& mesh, const MetEdge& met);

/// Whether the surface that is seen beyond the end of an edge of two faces touches it there, as far
/// as rounding can tell.
[[nodiscard]] bool is_touched(const ClipMesh& mesh, const MetEdge& end, const Sample& beyond);

/// Whether a point lies on one of the sides of a face, as far as rounding can tell.
[[nodiscard]] bool is_on_side(const ClipMesh& mesh,
                              std::uint32_t face,
                              const scene::RoundedPoint& point);

/// Whether the surface that is seen beyond an end already covers the end itself: then the two cross
/// just before it, and it is not seen. By the height over the plane, not by depths: an edge that a
/// modeller put into a wall lies in it to within the rounding of its floats, on either side.
[[nodiscard]] bool is_under(const ClipMesh& mesh, const MetEdge& end, const Sample& beyond);

/// Whether a feature that the way from `sample` passed comes out beyond the surface seen at
/// `other`, which neither covers nor touches it.
[[nodiscard]] bool is_out(const ClipMesh& mesh, const MetEdge& met, const Sample& other);

}  // namespace ink::crosscheck::walking
