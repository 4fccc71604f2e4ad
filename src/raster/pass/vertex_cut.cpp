#include "raster/pass/vertex_cut.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "raster/pass/clip.h"

namespace ink::raster {
namespace {

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
    p.z = plane == 0 ? near : std::max(p.z, near);  // see clip.cpp
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
