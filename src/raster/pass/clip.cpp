#include "raster/pass/clip.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <tuple>

#include "raster/pass/screen_vertex.h"

namespace ink::raster {
namespace {

bool comes_first(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The point of the edge on the plane; the same bits for (a, b) and (b, a).
ClipVertex cut(const ClipVertex& a, const ClipVertex& b, int plane, double near) {
    if (comes_first(b.p_clip, a.p_clip)) return cut(b, a, plane, near);
    const double from = inside_by(plane, a.p_clip, near, kGuardBand_px);
    const double t = from / (from - inside_by(plane, b.p_clip, near, kGuardBand_px));
    ClipVertex result;
    result.p_clip = a.p_clip + t * (b.p_clip - a.p_clip);
    // Exactly: rounding must not leave it before the plane. Nor must it at the other planes, where
    // an end may be so far away that the difference to the other has no digit of that one's w.
    result.p_clip.z = plane == 0 ? near : std::max(result.p_clip.z, near);
    for (std::size_t i = 0; i < kMaxPlanes; ++i)
        result.values[i] = a.values[i] + t * (b.values[i] - a.values[i]);
    return result;
}

ClipPolygon clip_at(const ClipPolygon& polygon, int plane, double near) {
    ClipPolygon result;
    const auto add = [&](const ClipVertex& v) {
        // Rounding could make a polygon slightly concave and cross a plane four times; the corner
        // too many lies within that rounding of another.
        if (result.count < ClipPolygon::kMaxCorners)
            result.corners[static_cast<std::size_t>(result.count++)] = v;
    };
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& from = polygon.corners[static_cast<std::size_t>(i)];
        const ClipVertex& to = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
        const bool from_inside = inside_by(plane, from.p_clip, near, kGuardBand_px) >= 0;
        const bool to_inside = inside_by(plane, to.p_clip, near, kGuardBand_px) >= 0;
        if (from_inside) add(from);
        if (from_inside != to_inside) add(cut(from, to, plane, near));
    }
    if (result.count < 3) result.count = 0;
    return result;
}

/// A triangle cut at five planes has at most eight corners.
struct Polygon {
    std::array<std::uint32_t, 3 + kClipPlanes> corners{};
    std::size_t count = 0;

    void add(std::uint32_t corner) {
        // Rounding could leave a corner too many, within that rounding of another.
        if (count < corners.size()) corners[count++] = corner;
    }
};

/// The corner where an edge passes a plane, reckoned from its inner end whichever way it is walked.
std::uint32_t cut_edge(std::uint32_t inside,
                       std::uint32_t outside,
                       std::pair<int, double> plane_near,
                       CutVertices& vertices) {
    const auto [plane, near] = plane_near;
    const glm::dvec3 a = vertices.p_clip[inside];
    const glm::dvec3 b = vertices.p_clip[outside];
    const double from = inside_by(plane, a, near, kCutBand_px);
    const double t = from / (from - inside_by(plane, b, near, kCutBand_px));
    glm::dvec3 p = a + t * (b - a);
    p.z = plane == 0 ? near : std::max(p.z, near);  // as `cut` has it
    const double share = vertices.is_parallel ? t * b.z / (a.z + t * (b.z - a.z)) : t;
    const glm::vec3 n =
        glm::mix(vertices.n[inside], vertices.n[outside], static_cast<float>(share));
    vertices.p_clip.push_back(p);
    vertices.n.push_back(n);
    return static_cast<std::uint32_t>(vertices.p_clip.size() - 1);
}

Polygon cut_at(const Polygon& polygon, int plane, double near, CutVertices& vertices) {
    Polygon result;
    const auto is_inside = [&](std::uint32_t corner) {
        return inside_by(plane, vertices.p_clip[corner], near, kCutBand_px) >= 0;
    };
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const std::uint32_t from = polygon.corners[i];
        const std::uint32_t to = polygon.corners[(i + 1) % polygon.count];
        const bool from_inside = is_inside(from);
        if (from_inside) result.add(from);
        if (from_inside == is_inside(to)) continue;
        result.add(from_inside ? cut_edge(from, to, {plane, near}, vertices)
                               : cut_edge(to, from, {plane, near}, vertices));
    }
    return result;
}

}  // namespace

double inside_by(int plane, const glm::dvec3& p_clip, double near, double band_px) {
    if (plane == 0) return p_clip.z - near;
    const double along = plane <= 2 ? p_clip.x : p_clip.y;
    return band_px * p_clip.z + (plane % 2 == 1 ? along : -along);
}

ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle, double near) {
    ClipPolygon polygon;
    for (std::size_t i = 0; i < 3; ++i)
        polygon.corners[i] = triangle[i];
    polygon.count = 3;
    for (int plane = 0; plane < kClipPlanes && polygon.count > 0; ++plane)
        polygon = clip_at(polygon, plane, near);
    return polygon;
}

void cut_triangles(std::span<const scene::Triangle> triangles,
                   std::span<const std::int8_t> facing,
                   double near,
                   CutVertices& vertices,
                   CutTriangles& out) {
    out.triangles.clear();
    out.facing.clear();
    out.source.clear();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        Polygon polygon;
        bool is_whole = true;
        for (const std::uint32_t corner : triangles[t]) {
            polygon.add(corner);
            is_whole = is_whole && !needs_cut(vertices.p_clip[corner], near);
        }
        for (int plane = 0; !is_whole && plane < kClipPlanes; ++plane) {
            polygon = cut_at(polygon, plane, near, vertices);
        }
        for (std::size_t i = 2; i < polygon.count; ++i) {
            out.triangles.push_back(
                {polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]});
            out.facing.push_back(facing[t]);
            out.source.push_back(static_cast<std::uint32_t>(t));
        }
    }
}

}  // namespace ink::raster
