#include "crosscheck/screen_segment.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ink::crosscheck {
namespace {

/// A stretch of a segment.
struct Range {
    double begin = 0, end = 1;
    [[nodiscard]] bool is_empty() const { return begin > end; }
};

/// Where a + s (b - a) lies between low and high, within `range`.
Range clip(Range range, double a, double b, double low, double high) {
    if (a == b) return a >= low && a <= high ? range : Range{1, 0};
    const auto [first, last] = std::minmax({(low - a) / (b - a), (high - a) / (b - a)});
    return {std::max(range.begin, first), std::min(range.end, last)};
}

}  // namespace

bool project_edge(const ClipMesh& mesh, const scene::Edge& edge, ScreenSegment& segment) {
    glm::dvec3 a = mesh.p_clip()[edge.a], b = mesh.p_clip()[edge.b];
    const double near = mesh.view().camera.near;
    if (a.z < near && b.z < near) return false;
    const glm::dvec3 cut = a + (b - a) * ((near - a.z) / (b.z - a.z));
    if (a.z < near) a = cut;
    if (b.z < near) b = cut;
    const ScreenSegment all{glm::dvec2(a) / a.z, glm::dvec2(b) / b.z, 1 / a.z, 1 / b.z};
    Range inside = clip({}, all.a.x, all.b.x, 0, mesh.view().width_px);
    inside = clip(inside, all.a.y, all.b.y, 0, mesh.view().height_px);
    if (inside.is_empty()) return false;
    segment = {
        all.at(inside.begin), all.at(inside.end), all.q_at(inside.begin), all.q_at(inside.end)};
    return true;
}

}  // namespace ink::crosscheck
