#pragma once

#include <vector>

#include "crosscheck/known_lines.h"

namespace ink::crosscheck {

/// Where found points and counts go.
struct Crossings {
    std::vector<CellPoint>& points;
    SamplingCounts& counts;
};

/// Adds a point for each line that crosses the way between two samples, to `cell`: the way is
/// halved down to 1/512 px wherever the ends of a part are not joined. A point stands for
/// `spacing_px` of line, divided by the line's slant. Points outside the image are left out.
void add_crossings(const SightRays& rays,
                   const Sample& a,
                   const Sample& b,
                   const glm::ivec2& cell,
                   double spacing_px,
                   Crossings& found);

}  // namespace ink::crosscheck
