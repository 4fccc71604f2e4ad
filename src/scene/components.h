#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/box.h"
#include "scene/topology.h"

namespace ink::scene {

/// An edge bent by less is taken for flat: more than rounding bends the diagonal of a planar quad,
/// less than any eye could see.
inline constexpr double kFlat_rad = 1e-3;

/// What can be reached over welded edges, objects notwithstanding.
struct Component {
    std::size_t faces = 0;
    Box box_world{};
    double radius = 0;           ///< from the box's centre to its farthest corner
    bool is_closed = false;      ///< each of its edges has exactly two faces
    bool is_consistent = false;  ///< neighbours run through their edge in opposite directions
    bool is_watertight = false;  ///< both, and turned outwards: its signed volume is positive
    /// Watertight, a ball by Euler's count, and bent outwards at every edge that is not flat: it
    /// cannot hide a part of its own front. A star that winds round itself twice would be taken for
    /// one.
    bool is_convex = false;
};

/// The components of a welded scene, in the order in which its faces meet them.
struct Components {
    std::vector<Component> components;
    std::vector<std::uint32_t> component_of;  ///< per face
};

/// Cuts a welded scene into its components. O(n log n).
[[nodiscard]] Components find_components(const Topology& topology);

/// The number of pairs of components whose boxes share a volume, or an area where one of them is
/// flat, and whose balls overlap: only those can pierce each other. Mere touching does not count.
/// Counting ends at `most`.
[[nodiscard]] std::size_t count_overlapping_components(const std::vector<Component>& components,
                                                       std::size_t most);

}  // namespace ink::scene
