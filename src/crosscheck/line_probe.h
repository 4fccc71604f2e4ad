#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/dense_sampling.h"

namespace ink::crosscheck {

/// Where somebody says that a line runs.
struct ClaimedPoint {
    glm::dvec2 p_px{0};
    truth::LineClass line_class = truth::LineClass::none;
};

/// Whether there is a line of the claimed class at each point: the third construction, which
/// decides where truth and cross-check differ.
///
/// Sees without Embree, by trying every triangle near the point with exact predicates. Looks at
/// opposite points of circles round the claimed one, from 1/512 px down to 2e-10 px, so that strips
/// far thinner than samples lie apart show. One entry per claim, 1 or 0; the same for every thread
/// count.
[[nodiscard]] std::vector<char> see_claimed_lines(const scene::Topology& topology,
                                                  const scene::View& view,
                                                  const SamplingOptions& options,
                                                  std::span<const ClaimedPoint> claims);

/// An edge of the mesh that somebody draws, and as what.
struct ClaimedEdge {
    std::uint32_t edge = 0;
    truth::LineClass line_class = truth::LineClass::none;
};

/// Whether each edge, seen as it is from one of its faces, is of the claimed class. One entry per
/// claim, 1 or 0.
[[nodiscard]] std::vector<char> name_claimed_edges(const scene::Topology& topology,
                                                   const scene::View& view,
                                                   const SamplingOptions& options,
                                                   std::span<const ClaimedEdge> claims);

/// Whether the digits of a file leave open what is seen at each place: two surfaces meet the line
/// of sight there, or pass it by 1/64 px, no farther from each other than half a unit of the last
/// decimal place may have moved both (Topology::written_rounding_world), and so little is less than
/// 1/64 px. Which of them is in front, and what line they make, is then chance: the cross-check has
/// nothing to say.
///
/// By distances from the points that are seen, without Embree. Faces with a common edge are one
/// surface, and those with a common vertex are near it. One entry per claim, 1 or 0; all 0 where
/// the scene has no few digits. The same for every thread count.
[[nodiscard]] std::vector<char> find_open_places(const scene::Topology& topology,
                                                 const scene::View& view,
                                                 const SamplingOptions& options,
                                                 std::span<const ClaimedPoint> claims);

}  // namespace ink::crosscheck
