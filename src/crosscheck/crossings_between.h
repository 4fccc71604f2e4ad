#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/known_lines.h"

namespace ink::crosscheck {

/// Where found points and counts go.
struct Crossings {
    std::vector<CellPoint>& points;
    SamplingCounts& counts;
};

/// A way between two samples and the cell that what crosses it belongs to.
struct CellWay : Way {
    glm::ivec2 cell{0};
};

/// Adds a point for each line that crosses one of the ways, way by way: each is halved down to
/// 1/512 px wherever the ends of a part are not joined, all of them together. A point stands for
/// `spacing_px` of line, divided by the line's slant. Points outside the image are left out.
void add_crossings(const SightRays& rays,
                   std::span<const CellWay> ways,
                   double spacing_px,
                   Crossings& found);

}  // namespace ink::crosscheck
