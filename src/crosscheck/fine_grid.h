#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "crosscheck/line_names.h"

namespace ink::crosscheck {

/// A point and the cell whose ways it was found on.
struct CellPoint {
    glm::ivec2 cell{0};
    SampledPoint point;
};

/// The K x K samples of one cell, with a row and a column of its neighbours': what dense sampling
/// does in a pixel that deserves it. One for each thread at work; used for cell after cell.
class FineGrid {
  public:
    /// Borrows the rays.
    FineGrid(const SightRays& rays, int k);

    /// Looks at the cell with its upper left corner at `corner_px`. What is seen at its corners is
    /// known: left to right, top to bottom.
    void look(const glm::ivec2& cell,
              const glm::dvec2& corner_px,
              const std::array<Sight, 4>& corners);

    /// Adds what crosses the ways from the cell's own K x K samples to the right and down: each way
    /// whose ends are not joined is halved down to 1/512 px. Points outside the image are left
    /// out.
    void add_points(std::vector<CellPoint>& points);

    /// Whether a line leaves the cell by the side whose samples are begin, begin + step, ...
    [[nodiscard]] bool is_crossed(glm::ivec2 begin, glm::ivec2 step) const;

    SamplingCounts counts;  ///< of all cells so far

  private:
    [[nodiscard]] Sample& at(int x, int y) { return samples_[y * (k_ + 1) + x]; }
    [[nodiscard]] const Sample& at(int x, int y) const { return samples_[y * (k_ + 1) + x]; }
    Sight look_at(const glm::dvec2& p_px);
    void add_between(const Sample& a, const Sample& b, std::vector<CellPoint>& points);
    void add_leaf(const Sample& a, const Sample& b, std::vector<CellPoint>& points);

    const SightRays& rays_;
    const ClipMesh& mesh_;
    int k_;
    glm::ivec2 cell_{0};
    std::vector<Sample> samples_;
};

}  // namespace ink::crosscheck
