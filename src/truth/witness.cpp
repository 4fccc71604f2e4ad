#include "truth/witness.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/parallel.h"
#include "truth/witness_cells.h"
#include "truth/witness_walk.h"

namespace ink::truth {
namespace {

constexpr double kFinest_px = 1.0 / 512;

/// The K x K samples of one pixel's cell, and a row and a column of its neighbours'.
class FineGrid {
  public:
    FineGrid(const WitnessMesh& mesh, const WitnessRays& rays, int k)
        : mesh_(mesh), rays_(rays), k_(k), samples_((k + 1) * (k + 1)) {}

    /// Looks at the cell with its corner at `corner_px`. `corners` are known: left to right, top to
    /// bottom.
    void look(const glm::dvec2& corner_px, const std::array<Sight, 4>& corners) {
        for (int y = 0; y <= k_; ++y) {
            for (int x = 0; x <= k_; ++x) {
                Sample& sample = at(x, y);
                sample.p_px = corner_px + glm::dvec2(x, y) / static_cast<double>(k_);
                if (x % k_ == 0 && y % k_ == 0) {
                    sample.sight = corners[(y / k_) * 2 + x / k_];
                } else {
                    sample.sight = look_at(sample.p_px);
                }
            }
        }
    }

    /// Adds what crosses the cell's ways to the right and down from its own K x K samples.
    void add_points(std::vector<WitnessPoint>& points) {
        for (int y = 0; y < k_; ++y) {
            for (int x = 0; x < k_; ++x) {
                add_between(at(x, y), at(x + 1, y), points);
                add_between(at(x, y), at(x, y + 1), points);
            }
        }
    }

    /// Whether a line leaves the cell by the side of which `begin` and `step` name the samples.
    [[nodiscard]] bool is_crossed(glm::ivec2 begin, glm::ivec2 step) const {
        for (int i = 0; i < k_; ++i) {
            const glm::ivec2 a = begin + step * i, b = a + step;
            if (!is_joined(mesh_, at(a.x, a.y), at(b.x, b.y))) return true;
        }
        return false;
    }

    WitnessCounts counts;

  private:
    [[nodiscard]] Sample& at(int x, int y) { return samples_[y * (k_ + 1) + x]; }
    [[nodiscard]] const Sample& at(int x, int y) const { return samples_[y * (k_ + 1) + x]; }

    Sight look_at(const glm::dvec2& p_px) {
        ++counts.rays;
        return rays_.look(p_px);
    }

    void add_between(const Sample& a, const Sample& b, std::vector<WitnessPoint>& points) {
        if (is_joined(mesh_, a, b)) return;
        if (glm::length(b.p_px - a.p_px) <= kFinest_px) {
            add_leaf(a, b, points);
            return;
        }
        Sample middle;
        middle.p_px = 0.5 * (a.p_px + b.p_px);
        middle.sight = look_at(middle.p_px);
        add_between(a, middle, points);
        add_between(middle, b, points);
    }

    void add_leaf(const Sample& a, const Sample& b, std::vector<WitnessPoint>& points) {
        const Between between = name_between(rays_, a, b);
        counts.defects += between.is_defect;
        counts.near_cuts += between.is_near_cut;
        counts.unexplained += !between.is_explained;
        const glm::dvec2 p = 0.5 * (a.p_px + b.p_px);
        const scene::View& view = mesh_.view();
        if (p.x < 0 || p.y < 0 || p.x >= view.width_px || p.y >= view.height_px) return;
        for (int i = 0; i < between.count; ++i) {
            const Crossing& line = between.lines[i];
            points.push_back({p.x, p.y, line.line_class, 1.0 / (k_ * line.slant)});
        }
    }

    const WitnessMesh& mesh_;
    const WitnessRays& rays_;
    int k_;
    std::vector<Sample> samples_;
};

/// What one row of cells gave, and which cells beside its refined ones a line runs into.
struct RowResult {
    std::vector<WitnessPoint> points;
    std::vector<glm::ivec2> entered;
    WitnessCounts counts;
};

class Looking {
  public:
    Looking(const scene::Topology& topology, const scene::View& view, const WitnessOptions& options)
        : mesh_(topology, view, options),
          rays_(mesh_, options.threads),
          options_(options),
          cells_(mesh_) {}

    Witness run() {
        cells_.look(rays_, options_.threads);
        result_.counts.rays += cells_.sample_count();
        if (options_.everywhere) {
            cells_.mark_all();
        } else {
            cells_.mark_crossed(options_.threads);
            cells_.mark_edges(options_.threads);
        }
        while (refine_marked()) {
        }
        std::stable_sort(result_.points.begin(),
                         result_.points.end(),
                         [](const WitnessPoint& a, const WitnessPoint& b) {
                             return std::floor(a.y_px) < std::floor(b.y_px);
                         });
        return std::move(result_);
    }

  private:
    /// Looks closely at every cell that is marked and was not looked at; true if that marked more.
    bool refine_marked() {
        std::vector<RowResult> rows(cells_.rows());
        core::parallel_for(rows.size(), options_.threads, [&](std::size_t row) {
            rows[row] = refine_row(static_cast<int>(row));
        });
        cells_.finish_marked();
        bool has_more = false;
        for (const RowResult& row : rows) {
            result_.points.insert(result_.points.end(), row.points.begin(), row.points.end());
            result_.counts.rays += row.counts.rays;
            result_.counts.refined_px += row.counts.refined_px;
            result_.counts.defects += row.counts.defects;
            result_.counts.near_cuts += row.counts.near_cuts;
            result_.counts.unexplained += row.counts.unexplained;
        }
        for (const RowResult& row : rows) {
            for (const glm::ivec2& cell : row.entered)
                has_more = cells_.mark(cell) || has_more;
        }
        return has_more;
    }

    RowResult refine_row(int y) {
        RowResult result;
        FineGrid grid(mesh_, rays_, options_.subsamples);
        const int k = options_.subsamples;
        std::size_t refined = 0;
        for (int x = 0; x < cells_.columns(); ++x) {
            const glm::ivec2 cell(x, y);
            if (cells_.state(cell) != CellState::marked) continue;
            ++refined;
            grid.look(cells_.corner_px(cell), cells_.corners(cell));
            grid.add_points(result.points);
            const auto enter = [&](glm::ivec2 neighbour, glm::ivec2 begin, glm::ivec2 step) {
                if (cells_.is_unseen(neighbour) && grid.is_crossed(begin, step))
                    result.entered.push_back(neighbour);
            };
            enter({x - 1, y}, {0, 0}, {0, 1});
            enter({x + 1, y}, {k, 0}, {0, 1});
            enter({x, y - 1}, {0, 0}, {1, 0});
            enter({x, y + 1}, {0, k}, {1, 0});
        }
        result.counts = grid.counts;
        result.counts.refined_px = refined;
        return result;
    }

    WitnessMesh mesh_;
    WitnessRays rays_;
    WitnessOptions options_;
    WitnessCells cells_;
    Witness result_;
};

}  // namespace

Witness find_witness(const scene::Topology& topology,
                     const scene::View& view,
                     const WitnessOptions& options) {
    if (topology.faces.empty() || view.width_px <= 0 || view.height_px <= 0) return {};
    return Looking(topology, view, options).run();
}

}  // namespace ink::truth
