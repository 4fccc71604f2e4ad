#pragma once

#include <vector>

#include "crosscheck/known_lines.h"
#include "crosscheck/sample_cells.h"

namespace ink::crosscheck {

/// What looking across the feature edges found.
struct EdgeProbes {
    std::vector<CellPoint> points;  ///< one for each line at each place that shows one
    std::vector<Way> ways;          ///< beside and along visible edges, whose ends are not joined
    SamplingCounts counts;
};

/// Looks 1/1024 px to either side of every feature edge, each 3/8 px along it, except where a
/// surface that goes on unbroken round the cell hides it; names what separates the two.
///
/// The edges say only where to look; whether there is a line, and of which class, is for the
/// samples to find. A line of another edge that shows there is a point without length: it has its
/// own places. At every other place that shows one, two more samples lie 1/2 px to either side:
/// what runs beside an edge, or ends at it, shows as a way whose ends are not joined.
[[nodiscard]] EdgeProbes probe_edges(const SampleCells& cells, const SightRays& rays, int threads);

}  // namespace ink::crosscheck
