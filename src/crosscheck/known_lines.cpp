#include "crosscheck/known_lines.h"
#include "crosscheck/line_names.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ink::crosscheck {
namespace {

constexpr double kFound_px = 0.2;             ///< points along an edge lie at most 3/8 px apart
constexpr double kBesideLine_px = 1.0 / 512;  ///< before and behind a line

constexpr double kFinest_px = 1.0 / 512;

bool is_long(const Way& way) {
    return glm::length(way.to.p_px - way.from.p_px) > kFinest_px;
}

/// Adds what separates two samples that lie very close and are not joined.
void add_crossing(const SightRays& rays, const CellWay& way, double spacing_px, Crossings& found) {
    const Between between = name_between(rays, way.from, way.to);
    found.counts.defects += between.is_defect;
    found.counts.near_cuts += between.is_near_cut;
    found.counts.unexplained += !between.is_explained;
    const glm::dvec2 p = 0.5 * (way.from.p_px + way.to.p_px);
    const scene::View& view = rays.mesh().view();
    if (p.x < 0 || p.y < 0 || p.x >= view.width_px || p.y >= view.height_px) return;
    for (int i = 0; i < between.count; ++i) {
        const NamedLine& line = between.lines[i];
        found.points.push_back({way.cell, {p.x, p.y, line.line_class, spacing_px / line.slant}});
    }
}

}  // namespace

KnownLines::KnownLines(const SampleCells& cells,
                       const ClipMesh& mesh,
                       std::span<const CellPoint> points)
    : cells_(cells),
      mesh_(mesh),
      points_(static_cast<std::size_t>(cells.columns()) * cells.rows(), [&](auto take) {
          for (const CellPoint& p : points)
              take(cells.index(p.cell), p.point);
      }) {}

bool KnownLines::has_near(const glm::dvec2& p_px,
                          truth::LineClass line_class,
                          double reach_px) const {
    const auto is_near = [&](const SampledPoint& q) {
        const double dx = q.x_px - p_px.x, dy = q.y_px - p_px.y;
        return q.line_class == line_class && dx * dx + dy * dy <= reach_px * reach_px;
    };
    const glm::ivec2 low = cells_.cell_of(p_px - reach_px), high = cells_.cell_of(p_px + reach_px);
    for (int y = low.y; y <= high.y; ++y) {
        const std::size_t first = cells_.index({low.x, y}), last = cells_.index({high.x, y});
        if (std::ranges::any_of(points_.of(first, last), is_near)) return true;
    }
    return false;
}

bool KnownLines::Meeting::is_stuck() const {
    return !is_last() && before + 2 * kBesideLine_px <= 0;
}

KnownLines::Meeting KnownLines::first_known(const Sample& from, const Sample& to) const {
    if (from.sight.face == kNothing) return {};
    const auto way = walking::walk(mesh_, from, to.p_px, walking::Stop::at_feature);
    if (way.met.line_class == truth::LineClass::none) return {};
    if (way.met.w < mesh_.view().camera.near) return {};
    const glm::dvec2 end_px = mesh_.px(way.met.p_world);
    if (!has_near(end_px, way.met.line_class, kFound_px)) return {};
    const glm::dvec2 d = glm::normalize(to.p_px - from.p_px);
    Meeting line;
    line.is_known = true;
    line.before = glm::dot(end_px - from.p_px, d) - kBesideLine_px;
    line.behind = glm::dot(to.p_px - end_px, d) - kBesideLine_px;
    line.before_px = end_px - kBesideLine_px * d;
    line.next_px = end_px + kBesideLine_px * d;
    return line;
}

void add_crossings(const SightRays& rays,
                   std::span<const CellWay> ways,
                   double spacing_px,
                   Crossings& found) {
    std::vector<CellWay> parts, halves;
    const auto add_open = [&](const CellWay& way, std::vector<CellWay>& to) {
        if (!is_joined(rays.mesh(), way.from, way.to)) to.push_back(way);
    };
    for (const CellWay& way : ways)
        add_open(way, parts);
    std::vector<Sample> middles;
    while (true) {
        middles.clear();
        for (const CellWay& part : parts) {
            if (is_long(part)) middles.push_back({0.5 * (part.from.p_px + part.to.p_px), {}});
        }
        if (middles.empty()) break;
        look_at_all(rays, middles);
        found.counts.rays += middles.size();
        halves.clear();
        auto middle = middles.begin();
        for (const CellWay& part : parts) {
            if (!is_long(part)) {
                halves.push_back(part);
                continue;
            }
            add_open({{part.from, *middle}, part.cell}, halves);
            add_open({{*middle, part.to}, part.cell}, halves);
            ++middle;
        }
        std::swap(parts, halves);
    }
    for (const CellWay& part : parts)
        add_crossing(rays, part, spacing_px, found);
}

}  // namespace ink::crosscheck
