#include "crosscheck/crossings_between.h"

#include <glm/geometric.hpp>

namespace ink::crosscheck {
namespace {

constexpr double kFinest_px = 1.0 / 512;

/// The same of two that lie very close and are not joined.
void add_crossing(const SightRays& rays,
                  const Sample& a,
                  const Sample& b,
                  const glm::ivec2& cell,
                  double spacing_px,
                  Crossings& found) {
    const Between between = name_between(rays, a, b);
    found.counts.defects += between.is_defect;
    found.counts.near_cuts += between.is_near_cut;
    found.counts.unexplained += !between.is_explained;
    const glm::dvec2 p = 0.5 * (a.p_px + b.p_px);
    const scene::View& view = rays.mesh().view();
    if (p.x < 0 || p.y < 0 || p.x >= view.width_px || p.y >= view.height_px) return;
    for (int i = 0; i < between.count; ++i) {
        const NamedLine& line = between.lines[i];
        found.points.push_back({cell, {p.x, p.y, line.line_class, spacing_px / line.slant}});
    }
}

}  // namespace

void add_crossings(const SightRays& rays,
                   const Sample& a,
                   const Sample& b,
                   const glm::ivec2& cell,
                   double spacing_px,
                   Crossings& found) {
    if (is_joined(rays.mesh(), a, b)) return;
    if (glm::length(b.p_px - a.p_px) <= kFinest_px) {
        add_crossing(rays, a, b, cell, spacing_px, found);
        return;
    }
    Sample middle;
    middle.p_px = 0.5 * (a.p_px + b.p_px);
    middle.sight = rays.look(middle.p_px);
    ++found.counts.rays;
    add_crossings(rays, a, middle, cell, spacing_px, found);
    add_crossings(rays, middle, b, cell, spacing_px, found);
}

}  // namespace ink::crosscheck
