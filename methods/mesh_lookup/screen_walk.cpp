// Of a walk what is rare: vertices that cannot be put on the screen, and edges of more than two
// faces.

#include "methods/mesh_lookup/screen_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/topology.h"

namespace ink::methods {

double ScreenMesh::Walk::height_off_screen(std::uint32_t vertex) const {
    const glm::dvec3 p = screen_.p_clip(vertex);
    return is_down_ ? p.x - (x_ + 0.5) * p.z : p.y - (y_ + 0.5) * p.z;
}

/// w where the line crosses the edge, not above 0 behind the eye, and s w, which holds there, too.
ScreenMesh::Walk::ClipPlace ScreenMesh::Walk::clip_place(const Passage& at) const {
    if (at.is_on_screen) return {1 / at.q, at.s * (1 / at.q)};
    const double place = is_down_ ? x_ + 0.5 : y_ + 0.5;
    const glm::dvec3 begin = screen_.p_clip(at.high), end = screen_.p_clip(at.low);
    const auto clip_height = [&](const glm::dvec3& p) {
        return (is_down_ ? p.x : p.y) - place * p.z;
    };
    const double ha = clip_height(begin), hb = clip_height(end);
    const double t = ha != hb ? std::clamp(ha / (ha - hb), 0.0, 1.0) : 0.5;
    const glm::dvec3 p = begin + t * (end - begin);
    return {p.z, sign_ * ((is_down_ ? p.y : p.x) - (0.5 + (is_down_ ? y_ : x_)) * p.z)};
}

void ScreenMesh::Walk::pass_off_screen(Passage& at) const {
    const ClipPlace place = clip_place(at);
    at.q = place.w > 0 ? 1 / place.w : 0;
    at.s = place.w > 0 ? place.s_w / place.w : std::numeric_limits<double>::infinity();
}

/// For w of either sign.
bool ScreenMesh::Walk::is_ahead_off_screen(const Passage& at, const Passage& other) const {
    const ClipPlace place = clip_place(at), before = clip_place(other);
    return place.s_w * before.w > before.s_w * place.w;
}

/// How fast 1/w grows from an edge into a face, per px.
double ScreenMesh::Walk::slope(const Passage& out, std::uint32_t third) const {
    const Vertex a = screen_.vertex(out.high);
    const Vertex b = screen_.vertex(out.low);
    const Vertex c = screen_.vertex(third);
    if (!a.is_on_screen() || !b.is_on_screen() || !c.is_on_screen()) return 0;
    const double ex = b.x - a.x, ey = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double length2 = ex * ex + ey * ey;
    const double distance = std::abs(ex * cy - ey * cx);
    if (!(length2 > 0) || !(distance > 0)) return 0;
    const double foot = a.q + (b.q - a.q) * (ex * cx + ey * cy) / length2;
    return (c.q - foot) * std::sqrt(length2) / distance;
}

/// Of several faces beyond an edge that nearest the eye.
ScreenMesh::Walk::Landing ScreenMesh::Walk::nearest_of_many(std::size_t exit,
                                                            const Passage& out,
                                                            int mine) {
    const std::uint32_t low = std::min(out.high, out.low), high = std::max(out.high, out.low);
    const auto& many = screen_.mesh_->many;
    const glm::dvec3 a = p_world(out.high), b = p_world(out.low);
    std::uint32_t best = kNoNeighbour;
    std::size_t best_third = 0;
    double best_slope = 0;
    const double own_slope = slope(out, screen_.mesh_->faces[at_].vertices[(exit + 2) % 3]);
    // Faces that lie on each other hide nothing, whichever rounding on the screen puts in
    // front.
    const glm::dvec3 n = glm::normalize(
        glm::cross(b - a, p_world(screen_.mesh_->faces[at_].vertices[(exit + 2) % 3]) - a));
    const double tolerance = screen_.mesh_->tolerance_world[screen_.mesh_->objects[at_]];
    for (auto at = std::lower_bound(many.begin(), many.end(), ManyFaces{low, high, 0});
         at != many.end() && at->a == low && at->b == high;
         ++at) {
        if (at->face == at_) continue;
        const auto& v = screen_.mesh_->faces[at->face].vertices;
        const auto third = static_cast<std::size_t>(
            std::find_if(
                v.begin(), v.end(), [&](std::uint32_t i) { return i != low && i != high; }) -
            v.begin());
        const int beside = mine * screen_.side_of(out.high, out.low, v[third]);
        if (beside == 0) continue;
        const double grows = slope(out, v[third]);
        if (beside > 0) {
            const bool is_apart = std::abs(glm::dot(n, p_world(v[third]) - a)) > tolerance;
            if (is_apart && grows > own_slope) end_ = End::hidden;
            continue;
        }
        if (best != kNoNeighbour && grows <= best_slope) continue;
        best = at->face;
        best_third = third;
        best_slope = grows;
    }
    if (best == kNoNeighbour) {
        kind_ = LineKind::contour;
        return {};
    }
    const LookupFace& face = screen_.mesh_->faces[at_];
    const double deviation =
        scene::deviation_rad({a, b, p_world(face.vertices[(exit + 2) % 3])},
                             {a, b, p_world(screen_.mesh_->faces[best].vertices[best_third])});
    if (deviation >= screen_.options_.crease_rad) {
        kind_ = LineKind::crease;
    } else if (screen_.mesh_->objects[at_] != screen_.mesh_->objects[best]) {
        kind_ = LineKind::seam;
    }
    return {best, (best_third + 1) % 3};
}

}  // namespace ink::methods
