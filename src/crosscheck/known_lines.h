#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/keyed_lists.h"
#include "crosscheck/sample_cells.h"

namespace ink::crosscheck {

/// A point of a line and the cell that it lies in.
struct CellPoint {
    glm::ivec2 cell{0};
    SampledPoint point;
};

/// Lines found so far. Read by many threads.
class KnownLines {
  public:
    /// Sorts the points into cells. Borrows cells and mesh.
    KnownLines(const SampleCells& cells, const ClipMesh& mesh, std::span<const CellPoint> points);

    /// Whether there is a point of the class within `reach_px` (at most 1) of `p_px`.
    [[nodiscard]] bool has_near(const glm::dvec2& p_px,
                                truth::LineClass line_class,
                                double reach_px) const;

    /// Where a way first meets a known line.
    struct Meeting {
        bool is_known = false;
        double before = 0;  ///< px of the way that lie well before the line
        double behind = 0;  ///< and well behind it
        glm::dvec2 before_px{0}, next_px{0};

        [[nodiscard]] bool is_last() const { return behind <= 0; }
        /// From behind an edge the same must not be met again and again.
        [[nodiscard]] bool is_stuck() const;
    };
    /// Follows the surface from the one sample towards the other, to the first feature edge.
    [[nodiscard]] Meeting first_known(const Sample& from, const Sample& to) const;

    [[nodiscard]] const ClipMesh& mesh() const { return mesh_; }

  private:
    const SampleCells& cells_;
    const ClipMesh& mesh_;
    core::KeyedLists<SampledPoint> points_;  ///< by cell
};

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

/// What is to be explained: the whole way, or only the first line that it crosses.
enum class Reach { whole, first_line };

/// For each way 1 if it is explained, else 0. Adds to `rays` the looks it took.
[[nodiscard]] std::vector<char> explain_all(const KnownLines& known,
                                            const SightRays& rays,
                                            std::span<const Way> ways,
                                            Reach reach,
                                            std::size_t& ray_count);

}  // namespace ink::crosscheck
