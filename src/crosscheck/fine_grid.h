#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/crossings_between.h"
#include "crosscheck/known_lines.h"

namespace ink::crosscheck {

/// The K x K samples of one cell, with a row and a column of its neighbours': what dense sampling
/// does in a pixel that deserves it. One for each thread at work; used for cell after cell.
class FineGrid {
  public:
    /// Borrows the rays and the known lines, which may be null.
    FineGrid(const SightRays& rays, const KnownLines* known, int k);

    /// Looks at the cell with its upper left corner at `corner_px`.
    void look(const glm::ivec2& cell, const glm::dvec2& corner_px);

    /// Adds what crosses the ways from the cell's own K x K samples to the right and down: each way
    /// whose ends are not joined and which known lines do not explain is halved down to 1/512 px.
    /// Points outside the image, and those of lines known there, are left out.
    void add_points(std::vector<CellPoint>& points);

    /// Whether a line that is not known leaves the cell by the side whose samples are begin,
    /// begin + step, ...
    [[nodiscard]] bool is_crossed(glm::ivec2 begin, glm::ivec2 step);

    SamplingCounts counts;  ///< of all cells so far

  private:
    [[nodiscard]] Sample& at(int x, int y) { return samples_[y * (k_ + 1) + x]; }
    /// For each way 1 if nothing but known lines lies between its ends.
    [[nodiscard]] std::vector<char> judge(std::span<const Way> ways);

    const SightRays& rays_;
    const KnownLines* known_;
    int k_;
    glm::ivec2 cell_{0};
    std::vector<Sample> samples_;
};

}  // namespace ink::crosscheck
