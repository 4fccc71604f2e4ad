#include "crosscheck/dense_sampling.h"

#include <algorithm>
#include <glm/vec2.hpp>
#include <span>
#include <tuple>
#include <utility>

#include "core/parallel.h"
#include "crosscheck/edge_probes.h"
#include "crosscheck/known_lines.h"
#include "crosscheck/sample_cells.h"

namespace ink::crosscheck {
namespace {

constexpr int kSubsamples = 8;      ///< K: a refined pixel is looked at K x K times
constexpr double kSame_px = 0.125;  ///< a point this near a known one is of the same line

/// The K x K samples of one cell, with a row and a column of its neighbours': what dense sampling
/// does in a pixel that deserves it. One for each thread at work; used for cell after cell.
class FineGrid {
  public:
    /// Borrows the rays and the known lines, which may be null.
    FineGrid(const SightRays& rays, const KnownLines* known) : rays_(rays), known_(known) {}

    /// Looks at the cell with its upper left corner at `corner_px`.
    void look(const glm::ivec2& cell, const glm::dvec2& corner_px) {
        cell_ = cell;
        ++counts.refined_px;
        for (int y = 0; y <= kSubsamples; ++y) {
            for (int x = 0; x <= kSubsamples; ++x) {
                Sample& sample = at(x, y);
                sample.p_px = corner_px + glm::dvec2(x, y) / double{kSubsamples};
            }
        }
        look_at_all(rays_, samples_);
        counts.rays += samples_.size();
    }

    /// Adds what crosses the ways from the cell's own K x K samples to the right and down: each way
    /// whose ends are not joined and which known lines do not explain is halved down to 1/512 px.
    /// Points outside the image, and those of lines known there, are left out.
    void add_points(std::vector<CellPoint>& points) {
        std::vector<Way> ways;
        for (int y = 0; y < kSubsamples; ++y) {
            for (int x = 0; x < kSubsamples; ++x) {
                ways.push_back({at(x, y), at(x + 1, y)});
                ways.push_back({at(x, y), at(x, y + 1)});
            }
        }
        const std::vector<char> is_plain = judge(ways);
        std::vector<CellWay> open;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (is_plain[i] == 0) open.push_back({ways[i], cell_});
        }
        std::vector<CellPoint> all;
        Crossings found{all, counts};
        add_crossings(rays_, open, 1.0 / kSubsamples, found);
        for (const CellPoint& p : all) {
            const bool is_known =
                known_ != nullptr &&
                known_->has_near({p.point.x_px, p.point.y_px}, p.point.line_class, kSame_px);
            if (!is_known) points.push_back(p);
        }
    }

    /// Whether a line that is not known leaves the cell by the side whose samples are begin,
    /// begin + step, ...
    [[nodiscard]] bool is_crossed(glm::ivec2 begin, glm::ivec2 step) {
        std::vector<Way> ways;
        for (int i = 0; i < kSubsamples; ++i) {
            const glm::ivec2 a = begin + step * i, b = a + step;
            ways.push_back({at(a.x, a.y), at(b.x, b.y)});
        }
        const std::vector<char> is_plain = judge(ways);
        return std::ranges::find(is_plain, 0) != is_plain.end();
    }

    SamplingCounts counts;  ///< of all cells so far

  private:
    [[nodiscard]] Sample& at(int x, int y) { return samples_[y * (kSubsamples + 1) + x]; }
    /// For each way 1 if nothing but known lines lies between its ends.
    [[nodiscard]] std::vector<char> judge(std::span<const Way> ways) {
        if (known_ != nullptr) return explain_all(*known_, rays_, ways, Reach::whole, counts.rays);
        std::vector<char> is_plain(ways.size());
        std::ranges::transform(ways, is_plain.begin(), [&](const Way& way) {
            return is_joined(rays_.mesh(), way.from, way.to);
        });
        return is_plain;
    }

    const SightRays& rays_;
    const KnownLines* known_;
    glm::ivec2 cell_{0};
    std::vector<Sample> samples_ = std::vector<Sample>((kSubsamples + 1) * (kSubsamples + 1));
};

constexpr std::size_t kChunk = 256;   ///< ways judged by one thread in one go
constexpr std::size_t kCells = 16;    ///< looked at closely
constexpr double kWay_px = 1.0 / 16;  ///< of line, for a crossing of a way: the grid finds the rest

/// What one chunk of cells or of ways gave, and which cells deserve a close look for it.
struct Part {
    std::vector<CellPoint> points;
    std::vector<glm::ivec2> cells;
    SamplingCounts counts;
};

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
            refine(nullptr);
        } else {
            look_adaptively();
        }
        std::ranges::stable_sort(points_, [](const CellPoint& a, const CellPoint& b) {
            return std::tie(a.cell.y, a.cell.x) < std::tie(b.cell.y, b.cell.x);
        });
        SampledLines crosscheck;
        for (const CellPoint& p : points_)
            crosscheck.points.push_back(p.point);
        crosscheck.counts = counts_;
        return crosscheck;
    }

  private:
    void look_adaptively() {
        cells_.compare(options_.threads);
        EdgeProbes probes = probe_edges(cells_, rays_, options_.threads);
        counts_ += probes.counts;
        points_ = std::move(probes.points);
        const KnownLines edges(cells_, mesh_, points_);
        judge_ways(edges, probes.ways);
        judge_lattice(edges);
        refine(&edges);
    }

    /// Marks the cells of ways that begin beside an edge and first cross something unknown, and
    /// adds what it is. What comes after a known line is seen from there.
    void judge_ways(const KnownLines& edges, const std::vector<Way>& all) {
        take(in_chunks(all.size(), kChunk, [&](std::size_t begin, std::size_t end, Part& part) {
            using enum Reach;
            std::vector<Way> ways(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                  all.begin() + static_cast<std::ptrdiff_t>(end));
            for (const auto reach : {first_line, whole})
                keep_unexplained(edges, reach, ways, part);
            std::vector<CellWay> open;
            for (const Way& way : ways) {
                const glm::dvec2 middle = 0.5 * (way.from.p_px + way.to.p_px);
                for (const glm::dvec2& p : {way.from.p_px, middle, way.to.p_px})
                    part.cells.push_back(cells_.cell_of(p));
                open.push_back({way, cells_.cell_of(middle)});
            }
            Crossings found{part.points, part.counts};
            add_crossings(rays_, open, kWay_px, found);
        }));
    }

    /// Marks the cells beside neighbouring corners that the edges do not explain, even once these
    /// have been looked at exactly.
    void judge_lattice(const KnownLines& edges) {
        const std::vector<LatticeWay>& all = cells_.open_ways();
        take(in_chunks(all.size(), kChunk, [&](std::size_t begin, std::size_t end, Part& part) {
            std::vector<LatticeWay> ways(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                         all.begin() + static_cast<std::ptrdiff_t>(end));
            keep_unexplained(edges, Reach::whole, ways, part);
            std::vector<Sample> ends;
            for (const LatticeWay& way : ways)
                ends.insert(ends.end(), {way.from, way.to});
            look_at_all(rays_, ends);
            part.counts.rays += ends.size();
            for (std::size_t i = 0; i < ways.size(); ++i) {
                ways[i].from = ends[2 * i];
                ways[i].to = ends[2 * i + 1];
            }
            keep_unexplained(edges, Reach::whole, ways, part);
            for (const LatticeWay& way : ways)
                part.cells.insert(part.cells.end(), way.cells.begin(), way.cells.end());
        }));
    }

    /// Takes away the ways that the edges explain.
    template <class W>
    void keep_unexplained(const KnownLines& edges,
                          Reach reach,
                          std::vector<W>& ways,
                          Part& part) const {
        const std::vector<Way> plain(ways.begin(), ways.end());
        const auto is_explained = explain_all(edges, rays_, plain, reach, part.counts.rays);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (is_explained[i] == 0) ways[kept++] = ways[i];
        }
        ways.resize(kept);
    }

    /// Calls `body(begin, end, part)` for each chunk of that size, with a part of its own.
    template <class Body>
    std::vector<Part> in_chunks(std::size_t count, std::size_t size, const Body& body) const {
        return core::parallel_parts<Part>(count, size, options_.threads, body);
    }

    /// Adds what the parts found; true if they marked a cell.
    bool take(const std::vector<Part>& parts) {
        bool has_marked = false;
        for (const Part& part : parts) {
            points_.insert(points_.end(), part.points.begin(), part.points.end());
            counts_ += part.counts;
            for (const glm::ivec2& cell : part.cells)
                has_marked = cells_.mark(cell) || has_marked;
        }
        return has_marked;
    }

    /// Looks closely at every cell that is marked, and at those that an unknown line enters from
    /// there.
    void refine(const KnownLines* known) {
        bool has_more = true;
        while (has_more) {
            // Those that many lines run together in often lie in a few rows.
            const std::vector<glm::ivec2> marked = cells_.marked();
            const auto parts = in_chunks(
                marked.size(), kCells, [&](std::size_t begin, std::size_t end, Part& part) {
                    refine_cells({marked.data() + begin, end - begin}, known, part);
                });
            cells_.finish_marked();
            has_more = take(parts);
        }
    }

    void refine_cells(std::span<const glm::ivec2> marked, const KnownLines* known, Part& part) {
        FineGrid grid(rays_, known);
        for (const glm::ivec2& cell : marked) {
            grid.look(cell, cells_.corner_px(cell));
            grid.add_points(part.points);
            const auto enter = [&](glm::ivec2 neighbour, glm::ivec2 begin, glm::ivec2 step) {
                if (cells_.is_unseen(neighbour) && grid.is_crossed(begin, step))
                    part.cells.push_back(neighbour);
            };
            const auto [x, y] = std::pair(cell.x, cell.y);
            enter({x - 1, y}, {0, 0}, {0, 1});
            enter({x + 1, y}, {kSubsamples, 0}, {0, 1});
            enter({x, y - 1}, {0, 0}, {1, 0});
            enter({x, y + 1}, {0, kSubsamples}, {1, 0});
        }
        part.counts = grid.counts;
    }

    ClipMesh mesh_;
    EmbreeRays rays_;
    SamplingOptions options_;
    SampleCells cells_;
    std::vector<CellPoint> points_;
    SamplingCounts counts_;
};

}  // namespace

SamplingCounts& SamplingCounts::operator+=(const SamplingCounts& other) {
    rays += other.rays;
    refined_px += other.refined_px;
    probes += other.probes;
    defects += other.defects;
    near_cuts += other.near_cuts;
    unexplained += other.unexplained;
    return *this;
}

SampledLines sample_lines(const scene::Topology& topology,
                          const scene::View& view,
                          const SamplingOptions& options) {
    if (topology.faces.empty() || view.width_px <= 0 || view.height_px <= 0) return {};
    return Looking(topology, view, options).run();
}

}  // namespace ink::crosscheck
