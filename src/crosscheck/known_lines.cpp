#include "crosscheck/known_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ink::crosscheck {
namespace {

constexpr double kFound_px = 0.2;         ///< points along an edge lie at most 3/8 px apart
constexpr double kBeside_px = 1.0 / 512;  ///< before and behind a line
constexpr int kMostLines = 8;             ///< that one way may cross and be explained

}  // namespace

KnownLines::KnownLines(const SampleCells& cells,
                       const SightRays& rays,
                       std::span<const CellPoint> points)
    : cells_(cells),
      rays_(rays),
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

bool KnownLines::has_near(const glm::dvec2& p_px,
                          truth::LineClass line_class,
                          double reach_px) const {
    const auto is_near = [&](const SampledPoint& q) {
        const double dx = q.x_px - p_px.x, dy = q.y_px - p_px.y;
        return q.line_class == line_class && dx * dx + dy * dy <= reach_px * reach_px;
    };
    const glm::ivec2 low = cells_.cell_of(p_px - reach_px), high = cells_.cell_of(p_px + reach_px);
    for (int y = low.y; y <= high.y; ++y) {
        const auto at = [&](std::size_t i) {
            return points_.begin() + static_cast<std::ptrdiff_t>(first_[i]);
        };
        const auto begin = at(cells_.index({low.x, y})), end = at(cells_.index({high.x, y}) + 1);
        if (std::any_of(begin, end, is_near)) return true;
    }
    return false;
}

bool KnownLines::explain(const Sample& from, const Sample& to, std::size_t& rays) const {
    return explain(from, to, kMostLines, rays);
}

bool KnownLines::explain(const Sample& from,
                         const Sample& to,
                         int most_lines,
                         std::size_t& rays) const {
    if (is_joined(rays_.mesh(), from, to)) return true;
    if (most_lines == 0) return false;
    for (const auto& [begin, end] : {std::pair(from, to), std::pair(to, from)}) {
        const Passage line = pass(begin, end, rays);
        if (!line.is_known) continue;
        if (line.is_last) return true;
        ++rays;
        const Sample next{line.next_px, rays_.look(line.next_px)};
        if (explain(next, end, most_lines - 1, rays)) return true;
    }
    return false;
}

bool KnownLines::explain_first(const Sample& from, const Sample& to, std::size_t& rays) const {
    return pass(from, to, rays).is_known;
}

KnownLines::Passage KnownLines::pass(const Sample& from,
                                     const Sample& to,
                                     std::size_t& rays) const {
    if (from.sight.face == kNothing) return {};
    const ClipMesh& mesh = rays_.mesh();
    const auto way = walking::walk(mesh, from, to.p_px, walking::Stop::at_feature);
    if (way.met.line_class == truth::LineClass::none) return {};
    if (way.met.w < mesh.view().camera.near) return {};
    const glm::dvec2 end_px = mesh.px(way.met.p_world);
    if (!has_near(end_px, way.met.line_class, kFound_px)) return {};
    const glm::dvec2 d = glm::normalize(to.p_px - from.p_px);
    const double before = glm::dot(end_px - from.p_px, d) - kBeside_px;
    const double behind = glm::dot(to.p_px - end_px, d) - kBeside_px;
    // The edge is what ends the surface only if the surface is seen up to it.
    if (before > 0) {
        const glm::dvec2 before_px = end_px - kBeside_px * d;
        ++rays;
        if (!is_joined(mesh, from, {before_px, rays_.look(before_px)})) return {};
    }
    // From behind an edge the same must not be met again and again.
    const bool is_last = behind <= 0;
    if (!is_last && before + 2 * kBeside_px <= 0) return {};
    return {true, is_last, end_px + kBeside_px * d};
}

}  // namespace ink::crosscheck
