#include "crosscheck/dense_sampling.h"

#include <algorithm>
#include <tuple>

#include "core/parallel.h"
#include "crosscheck/fine_grid.h"
#include "crosscheck/sample_cells.h"
#include "crosscheck/thin_cells.h"

namespace ink::crosscheck {
namespace {

constexpr int kThinFactor = 4;  ///< so many times as dense where the samples stepped over something

/// What one row of cells gave, and which cells beside its refined ones a line runs into.
struct RowResult {
    std::vector<CellPoint> points;
    std::vector<glm::ivec2> entered;
    SamplingCounts counts;
};

void add(const SamplingCounts& part, SamplingCounts& sum) {
    sum.rays += part.rays;
    sum.refined_px += part.refined_px;
    sum.defects += part.defects;
    sum.near_cuts += part.near_cuts;
    sum.unexplained += part.unexplained;
}

class Looking {
  public:
    Looking(const scene::Topology& topology,
            const scene::View& view,
            const SamplingOptions& options)
        : mesh_(topology, view, options),
          rays_(mesh_, options.threads),
          options_(options),
          cells_(mesh_) {}

    SampledLines run() {
        cells_.look(rays_, options_.threads);
        counts_.rays += cells_.sample_count();
        if (options_.everywhere) {
            cells_.mark_all();
        } else {
            cells_.mark_crossed(options_.threads);
            cells_.mark_edges(options_.threads);
        }
        while (refine_marked()) {
        }
        if (!options_.everywhere) refine_thin();
        std::stable_sort(
            points_.begin(), points_.end(), [](const CellPoint& a, const CellPoint& b) {
                return std::tie(a.cell.y, a.cell.x) < std::tie(b.cell.y, b.cell.x);
            });
        SampledLines crosscheck;
        for (const CellPoint& p : points_)
            crosscheck.points.push_back(p.point);
        crosscheck.counts = counts_;
        return crosscheck;
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
            points_.insert(points_.end(), row.points.begin(), row.points.end());
            add(row.counts, counts_);
            for (const glm::ivec2& cell : row.entered)
                has_more = cells_.mark(cell) || has_more;
        }
        return has_more;
    }

    RowResult refine_row(int y) {
        RowResult result;
        FineGrid grid(rays_, options_.subsamples);
        const int k = options_.subsamples;
        for (int x = 0; x < cells_.columns(); ++x) {
            const glm::ivec2 cell(x, y);
            if (cells_.state(cell) != CellState::marked) continue;
            grid.look(cell, cells_.corner_px(cell), cells_.corners(cell));
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
        return result;
    }

    /// Looks again, more densely, at the cells whose samples stepped over something.
    void refine_thin() {
        const ThinCells thin = find_thin_cells(cells_, rays_, points_, options_.threads);
        counts_.rays += thin.rays;
        counts_.thin_px = thin.cells.size();
        if (thin.cells.empty()) return;
        for (const glm::ivec2& cell : thin.cells)
            cells_.mark(cell, CellState::thin);
        points_.erase(std::remove_if(points_.begin(),
                                     points_.end(),
                                     [&](const CellPoint& p) {
                                         return cells_.state(p.cell) == CellState::thin;
                                     }),
                      points_.end());
        std::vector<RowResult> results(thin.cells.size());
        core::parallel_for(results.size(), options_.threads, [&](std::size_t i) {
            const glm::ivec2 cell = thin.cells[i];
            FineGrid grid(rays_, kThinFactor * options_.subsamples);
            grid.look(cell, cells_.corner_px(cell), cells_.corners(cell));
            grid.add_points(results[i].points);
            results[i].counts = grid.counts;
        });
        for (const RowResult& result : results) {
            points_.insert(points_.end(), result.points.begin(), result.points.end());
            counts_.rays += result.counts.rays;
        }
    }

    ClipMesh mesh_;
    SightRays rays_;
    SamplingOptions options_;
    SampleCells cells_;
    std::vector<CellPoint> points_;
    SamplingCounts counts_;
};

}  // namespace

SampledLines sample_lines(const scene::Topology& topology,
                          const scene::View& view,
                          const SamplingOptions& options) {
    if (topology.faces.empty() || view.width_px <= 0 || view.height_px <= 0) return {};
    return Looking(topology, view, options).run();
}

}  // namespace ink::crosscheck
