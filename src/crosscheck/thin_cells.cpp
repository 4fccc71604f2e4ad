#include "crosscheck/thin_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "crosscheck/mesh_walk.h"

namespace ink::crosscheck {
namespace {

constexpr double kSpacing_px = 1.0 / 8;
constexpr double kFound_px = 0.15;  ///< a point this close was found along the piece
constexpr double kAside_px = 1.0 / 256;
constexpr std::size_t kChunk = 1024;

/// The points by their cells.
class PointsByCell {
  public:
    PointsByCell(const SampleCells& cells, std::span<const CellPoint> points)
        : cells_(cells),
          first_(static_cast<std::size_t>(cells.columns()) * cells.rows() + 1, 0),
          points_(points.size()) {
        for (const CellPoint& p : points)
            ++first_[cells.index(p.cell) + 1];
        for (std::size_t i = 1; i < first_.size(); ++i)
            first_[i] += first_[i - 1];
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (const CellPoint& p : points)
            points_[next[cells.index(p.cell)]++] = p.point;
    }

    /// Whether there is one of the class (none: of any) within kFound_px of `p`, which lies in
    /// `cell`.
    [[nodiscard]] bool has_near(const glm::ivec2& cell,
                                const glm::dvec2& p,
                                truth::LineClass line_class) const {
        const auto is_near = [&](const SampledPoint& q) {
            return (line_class == truth::LineClass::none || q.line_class == line_class) &&
                   glm::length(p - glm::dvec2(q.x_px, q.y_px)) <= kFound_px;
        };
        for (int y = std::max(0, cell.y - 1); y <= std::min(cells_.rows() - 1, cell.y + 1); ++y) {
            const int left = std::max(0, cell.x - 1);
            const int right = std::min(cells_.columns() - 1, cell.x + 1);
            const auto begin =
                points_.begin() + static_cast<std::ptrdiff_t>(first_[cells_.index({left, y})]);
            const auto end =
                points_.begin() + static_cast<std::ptrdiff_t>(first_[cells_.index({right, y}) + 1]);
            if (std::any_of(begin, end, is_near)) return true;
        }
        return false;
    }

  private:
    const SampleCells& cells_;
    std::vector<std::size_t> first_;
    std::vector<SampledPoint> points_;
};

/// Whether the two sides of the piece differ somewhere where nothing was found.
bool is_stepped_over(const SightRays& rays,
                     const PointsByCell& found,
                     const EdgePiece& piece,
                     std::size_t& ray_count) {
    const truth::LineClass line_class = rays.mesh().likely_class(piece.edge);
    const glm::dvec2 along = piece.end_px - piece.begin_px;
    const double length = glm::length(along);
    if (!(length > 0)) return false;
    const glm::dvec2 aside = glm::dvec2(-along.y, along.x) / length * kAside_px;
    const int count = std::max(1, static_cast<int>(std::ceil(length / kSpacing_px)));
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 p = piece.begin_px + along * ((i + 0.5) / count);
        if (found.has_near(piece.cell, p, line_class)) continue;
        const Sample left{p - aside, rays.look(p - aside)};
        const Sample right{p + aside, rays.look(p + aside)};
        ray_count += 2;
        if (!is_joined(rays.mesh(), left, right)) return true;
    }
    return false;
}

}  // namespace

ThinCells find_thin_cells(const SampleCells& cells,
                          const SightRays& rays,
                          std::span<const CellPoint> points,
                          int threads) {
    const ClipMesh& mesh = rays.mesh();
    const PointsByCell found(cells, points);
    const std::size_t count = mesh.topology().edges.size();
    std::vector<ThinCells> parts((count + kChunk - 1) / kChunk);
    core::parallel_for(parts.size(), threads, [&](std::size_t chunk) {
        std::vector<EdgePiece> pieces;
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t e = chunk * kChunk; e < end; ++e) {
            if (mesh.is_feature(static_cast<std::uint32_t>(e)))
                cells.add_pieces(static_cast<std::uint32_t>(e), pieces);
        }
        for (const EdgePiece& piece : pieces) {
            if (is_stepped_over(rays, found, piece, parts[chunk].rays))
                parts[chunk].cells.push_back(piece.cell);
        }
    });
    ThinCells all;
    for (const ThinCells& part : parts) {
        all.cells.insert(all.cells.end(), part.cells.begin(), part.cells.end());
        all.rays += part.rays;
    }
    const auto by_rows = [](const glm::ivec2& a, const glm::ivec2& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    };
    std::sort(all.cells.begin(), all.cells.end(), by_rows);
    all.cells.erase(std::unique(all.cells.begin(), all.cells.end()), all.cells.end());
    return all;
}

}  // namespace ink::crosscheck
