#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/fine_grid.h"
#include "crosscheck/sample_cells.h"

namespace ink::crosscheck {

/// Cells in which something is seen that the samples stepped over, and what finding them cost.
struct ThinCells {
    std::vector<glm::ivec2> cells;  ///< by rows, each once
    std::size_t rays = 0;
};

/// Looks 1/256 px to either side of every unhidden piece of a feature edge by which no point was
/// found, and names the cells where the two looks are not joined: there a wedge, a slit or a spike
/// is thinner than the samples lie apart.
///
/// The edges say only where to look; whether there is a line is for the samples to find.
[[nodiscard]] ThinCells find_thin_cells(const SampleCells& cells,
                                        const SightRays& rays,
                                        std::span<const CellPoint> points,
                                        int threads);

}  // namespace ink::crosscheck
