#pragma once

#include "scene/components.h"
#include "scene/scene_statistics.h"

namespace ink::scene {

/// Two parallel faces this near to each other, as a share of the scene's radius, are near.
inline constexpr double kNearShare = 1e-2;

/// Pairs of faces of two components, parallel within about 1e-4 rad, whose boxes share an
/// area when one is slid onto the other's plane, and whose planes are within kNearShare of
/// `radius`. Each face is only held against the eight nearest of its direction, so that a heap of
/// sheets costs O(n log n): `pairs` is a lower bound, the least gap is that of neighbours.
[[nodiscard]] NearSheets find_near_sheets(const Topology& topology,
                                          const Components& components,
                                          double radius);

}  // namespace ink::scene
