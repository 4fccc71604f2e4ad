#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/line_names.h"
#include "crosscheck/sample_cells.h"

namespace ink::crosscheck {

/// A point of a line and the cell that it lies in.
struct CellPoint {
    glm::ivec2 cell{0};
    SampledPoint point;
};

/// Lines found so far, and whether they say why two samples differ. Read by many threads.
class KnownLines {
  public:
    /// Sorts the points into cells. Borrows cells and rays.
    KnownLines(const SampleCells& cells, const SightRays& rays, std::span<const CellPoint> points);

    /// Whether there is a point of the class within `reach_px` (at most 1) of `p_px`.
    [[nodiscard]] bool has_near(const glm::dvec2& p_px,
                                truth::LineClass line_class,
                                double reach_px) const;

    /// Whether the way from one sample to another crosses known lines alone: it is followed over
    /// the surface to the first feature edge, which must be a known line, and from what is seen
    /// just beyond that on to the next; from the other end where that fails. Adds to `rays` what it
    /// looked at.
    [[nodiscard]] bool explain(const Sample& from, const Sample& to, std::size_t& rays) const;
    /// Whether the first line that the way crosses is known, whatever comes after it.
    [[nodiscard]] bool explain_first(const Sample& from, const Sample& to, std::size_t& rays) const;

  private:
    /// Two points of a way, close before and behind a known line.
    struct Passage {
        bool is_known = false;
        bool is_last = false;  ///< the way ends there
        glm::dvec2 next_px{0};
    };
    [[nodiscard]] Passage pass(const Sample& from, const Sample& to, std::size_t& rays) const;
    [[nodiscard]] bool explain(const Sample& from,
                               const Sample& to,
                               int most_lines,
                               std::size_t& rays) const;

    const SampleCells& cells_;
    const SightRays& rays_;
    std::vector<std::size_t> first_;
    std::vector<SampledPoint> points_;
};

}  // namespace ink::crosscheck
