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

}  // namespace ink::crosscheck
