#include "crosscheck/crossings_between.h"

#include <glm/geometric.hpp>
#include <utility>

namespace ink::crosscheck {
namespace {

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
