#include "scene/holes/holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "core/disjoint_sets.h"
#include "core/equal_rows.h"
#include "scene/box.h"
#include "scene/camera.h"
#include "scene/clusters.h"
#include "scene/face_graph.h"
#include "scene/predicates.h"
#include "scene/surface.h"

namespace ink::scene {
namespace {

double square_of(const glm::dvec3& v) {
    return glm::dot(v, v);
}

/// The square of the distance to a triangle.
double square_to(const std::array<glm::dvec3, 3>& c, const glm::dvec3& p) {
    const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
    double least = square_of(p - c[0]);
    bool is_above = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = c[(i + 1) % 3] - c[i];
        const glm::dvec3 arm = p - c[i];
        is_above = is_above && glm::dot(glm::cross(n, edge), arm) >= 0;
        const double t = std::clamp(glm::dot(arm, edge) / square_of(edge), 0.0, 1.0);
        least = std::min(least, square_of(arm - edge * t));
    }
    if (!is_above) return least;
    const double height = glm::dot(n, p - c[0]);
    return std::min(least, height * height / square_of(n));
}

/// Clusters of one solid: they are in a row.
std::span<const Cluster> clusters_of(const Clusters& clusters, std::uint32_t solid) {
    return core::equal_rows(std::span(clusters.clusters), solid, &Cluster::solid);
}

/// Whether what lies of a solid outside all of the balls certainly hangs together, and is not
/// nothing. O(n log n).
///
/// A triangle leaves no piece outside a ball that does not hold one of its corners, since balls are
/// convex: so it is enough to join corners outside over triangles that meet no ball.
bool hangs_together_outside(const Surface& moved,
                            const Clusters& clusters,
                            std::uint32_t solid,
                            std::span<const Sphere> balls) {
    constexpr double kOutwards = 1 + 1e-9;
    const std::span<const Cluster> parts = clusters_of(clusters, solid);
    if (parts.empty()) return false;
    const auto first = clusters.places.begin();
    std::vector<std::uint32_t> places(
        first + parts.front().first_vertex,
        first + parts.back().first_vertex + parts.back().vertex_count);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    core::DisjointSets groups(places.size());
    for (const Cluster& cluster : parts) {
        std::array<std::uint32_t, kMaxClusterVertices> indices;
        for (std::size_t v = 0; v < cluster.vertex_count; ++v)
            indices[v] = static_cast<std::uint32_t>(
                std::ranges::lower_bound(places, clusters.places[cluster.first_vertex + v]) -
                places.begin());
        const bool is_near = std::ranges::any_of(balls, [&](const Sphere& ball) {
            const double reach = (ball.radius + cluster.bounds.radius) * kOutwards;
            return square_of(cluster.bounds.center_world - ball.center_world) <= reach * reach;
        });
        for (std::size_t t = 0; t < cluster.triangle_count; ++t) {
            const auto& corners = clusters.triangles[cluster.first_triangle + t];
            std::array<glm::dvec3, 3> p;
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = moved.p_world[clusters.vertices[cluster.first_vertex + corners[i]]];
            const auto meets = [&](const Sphere& ball) {
                const double radius = ball.radius * kOutwards;
                return !(square_to(p, ball.center_world) > radius * radius);
            };
            if (is_near && std::ranges::any_of(balls, meets)) continue;
            groups.join(indices[corners[0]], indices[corners[1]]);
            groups.join(indices[corners[0]], indices[corners[2]]);
        }
    }
    std::uint32_t outside = ~0U;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const glm::dvec3& p = moved.p_world[places[i]];
        const bool is_inside = std::ranges::any_of(balls, [&](const Sphere& ball) {
            return square_of(p - ball.center_world) < ball.radius * ball.radius / kOutwards;
        });
        if (is_inside) continue;
        if (outside != ~0U && groups.root(i) != outside) return false;
        outside = groups.root(i);
    }
    return outside != ~0U;
}

using Corners = std::array<glm::dvec3, 3>;

/// A side with one face, from a place on.
struct RimSide {
    std::uint32_t solid;
    std::uint32_t from;
    std::uint32_t to;
    bool is_walked = false;
};

std::vector<RimSide> list_rim_sides(const FaceGraph& graph) {
    std::vector<RimSide> sides;
    for (const std::uint32_t side : graph.rim_sides) {
        const std::uint32_t solid = graph.solid_of[side / 3];
        const std::uint32_t end = side % 3 == 2 ? side - 2 : side + 1;
        if (graph.has_rims_only[solid])
            sides.push_back({solid, graph.places[side], graph.places[end]});
    }
    std::ranges::sort(sides, {}, [](const RimSide& s) { return std::pair(s.solid, s.from); });
    return sides;
}

/// The rings of one solid's sides, which are sorted, behind what `clusters` has; false if they meet
/// or are too many.
bool walk_rings(std::span<RimSide> sides, const FaceGraph& graph, Clusters& clusters) {
    if (std::ranges::adjacent_find(sides, {}, &RimSide::from) != sides.end()) return false;
    std::size_t count = 0;
    for (RimSide& first : sides) {
        if (first.is_walked) continue;
        if (++count > kMostHoles) return false;
        Hole hole;
        hole.first_corner = static_cast<std::uint32_t>(clusters.rims.size());
        for (RimSide* side = &first; !side->is_walked;) {
            side->is_walked = true;
            clusters.rims.push_back(graph.corner_at[side->from]);
            const auto next = std::ranges::lower_bound(sides, side->to, {}, &RimSide::from);
            if (next == sides.end() || next->from != side->to) return false;
            side = &*next;
        }
        hole.corner_count = static_cast<std::uint32_t>(clusters.rims.size()) - hole.first_corner;
        if (hole.corner_count < 3) return false;
        clusters.holes.push_back(hole);
    }
    return true;
}

/// Whether a segment meets a triangle, exactly. One that lies in its plane does not count.
bool crosses(const glm::dvec3& p, const glm::dvec3& q, const Corners& c) {
    const int side_p = orient3d(c[0], c[1], c[2], p);
    if (side_p == orient3d(c[0], c[1], c[2], q)) return false;
    bool has_left = false, has_right = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int turn = orient3d(p, q, c[i], c[(i + 1) % 3]);
        has_left = has_left || turn < 0;
        has_right = has_right || turn > 0;
    }
    return !(has_left && has_right);
}

bool has_corner(const Corners& c, const glm::dvec3& p) {
    return c[0] == p || c[1] == p || c[2] == p;
}

/// Whether a face meets a triangle of a fan (two corners of the rim, apex) elsewhere than in their
/// corners and the rim's edge: then an edge of one of them crosses the other. Two edges of the fan
/// are enough: the third is an edge of the surface.
bool pierces(const Corners& face, const Corners& fan) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = face[i], &q = face[(i + 1) % 3];
        // From a corner of the rim it could only run through the plane there.
        const bool starts_there = p == fan[0] || p == fan[1] || q == fan[0] || q == fan[1];
        if (!starts_there && crosses(p, q, fan)) return true;
    }
    return (!has_corner(face, fan[0]) && crosses(fan[0], fan[2], face)) ||
           (!has_corner(face, fan[1]) && crosses(fan[1], fan[2], face));
}

/// The fan of a hole: against the direction that the faces run along the rim.
std::vector<Corners> fan_of(const Hole& hole, std::span<const glm::dvec3> rim_world) {
    std::vector<Corners> fan;
    for (std::size_t i = 0; i < rim_world.size(); ++i)
        fan.push_back({rim_world[(i + 1) % rim_world.size()], rim_world[i], hole.apex_world});
    return fan;
}

/// Twice the area that a fan's triangles enclose seen from its normal, along that normal: the same
/// for every apex.
glm::dvec3 shadow_of(const std::vector<Corners>& fan) {
    glm::dvec3 shadow{0};
    for (const auto& [a, b, c] : fan)
        shadow += glm::cross(b - a, c - a);
    return shadow;
}

/// Whether its area is more than twice that of its shadow.
bool is_folded(const std::vector<Corners>& fan) {
    double area = 0;
    for (const auto& [a, b, c] : fan)
        area += glm::length(glm::cross(b - a, c - a));
    return !(2 * glm::length(shadow_of(fan)) > area);
}

bool is_pierced(const Surface& moved,
                const Clusters& clusters,
                std::uint32_t solid,
                const Hole& hole,
                const std::vector<Corners>& fan) {
    std::vector<Box> boxes;
    Box all;
    for (const Corners& corners : fan) {
        boxes.push_back(box_of(corners));
        all.add(boxes.back());
    }
    for (const Cluster& cluster : clusters_of(clusters, solid)) {
        const double reach = cluster.bounds.radius + hole.bounds.radius;
        const glm::dvec3 way = cluster.bounds.center_world - hole.bounds.center_world;
        if (glm::dot(way, way) > reach * reach * (1 + 1e-9)) continue;
        for (std::size_t t = 0; t < cluster.triangle_count; ++t) {
            const auto& ids = moved.triangles[clusters.triangle_ids[cluster.first_triangle + t]];
            const Corners face{moved.p_world[ids[0]], moved.p_world[ids[1]], moved.p_world[ids[2]]};
            const Box box = box_of(face);
            if (!box.touches(all)) continue;
            for (std::size_t i = 0; i < fan.size(); ++i) {
                if (box.touches(boxes[i]) && pierces(face, fan[i])) return true;
            }
        }
    }
    return false;
}

/// Puts the apex of a hole `height` rim radii before the mean of its rim, and the ball round it.
void raise_apex(std::span<const glm::dvec3> rim_world, double height, Hole& hole) {
    glm::dvec3 sum{0};
    for (const glm::dvec3& p : rim_world)
        sum += p - rim_world.front();
    hole.apex_world = rim_world.front() + sum / double(rim_world.size());
    const auto reach = [&] {
        double square = 0;
        for (const glm::dvec3& p : rim_world)
            square = std::max(square, glm::dot(p - hole.apex_world, p - hole.apex_world));
        return std::sqrt(square);
    };
    const glm::dvec3 shadow = shadow_of(fan_of(hole, rim_world));
    const double size = glm::length(shadow);
    if (size > 0) hole.apex_world += shadow * (height * reach() / size);
    hole.bounds = {hole.apex_world, reach() * (1 + 1e-12)};
}

/// What the faces of a solid and the fans over its holes enclose.
struct CoveredVolume {
    OpenVolume volume;
    double balls = 0;  ///< of the balls that the fans lie in

    void add(const Hole& hole, const std::vector<Corners>& fan) {
        for (const auto& [a, b, c] : fan)
            volume.six_volumes += glm::dot(a - volume.origin_world, glm::cross(b - a, c - a));
        balls += 4.0 / 3 * std::numbers::pi * std::pow(hole.bounds.radius, 3);
    }
    [[nodiscard]] bool is_enough() const { return volume.six_volumes > 6 * 2 * balls; }
};

}  // namespace

void find_holes(const FaceGraph& graph, Clusters& clusters) {
    std::vector<RimSide> sides = list_rim_sides(graph);
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].solid == sides[first].solid)
            ++end;
        Solid& solid = clusters.solids[sides[first].solid];
        const std::size_t holes = clusters.holes.size();
        const std::size_t corners = clusters.rims.size();
        if (walk_rings({sides.data() + first, end - first}, graph, clusters)) {
            solid.first_hole = static_cast<std::uint32_t>(holes);
            solid.hole_count = static_cast<std::uint32_t>(clusters.holes.size() - holes);
        } else {
            clusters.holes.resize(holes);
            clusters.rims.resize(corners);
        }
    }
}

bool refresh_holes(const Surface& moved,
                   std::uint32_t solid,
                   const OpenVolume& volume,
                   Clusters& clusters) {
    const Solid& of = clusters.solids[solid];
    const std::span holes = std::span(clusters.holes).subspan(of.first_hole, of.hole_count);
    const auto rim_of = [&](const Hole& hole) {
        std::vector<glm::dvec3> rim;
        for (std::size_t i = 0; i < hole.corner_count; ++i)
            rim.push_back(moved.p_world[clusters.rims[hole.first_corner + i]]);
        return rim;
    };
    CoveredVolume flat{volume};
    for (Hole& hole : holes) {
        const std::vector<glm::dvec3> rim = rim_of(hole);
        raise_apex(rim, 0, hole);
        flat.add(hole, fan_of(hole, rim));
    }
    if (!flat.is_enough()) return false;  // before it costs more
    CoveredVolume covered{volume};
    std::vector<Sphere> open;
    for (Hole& hole : holes) {
        const std::vector<glm::dvec3> rim = rim_of(hole);
        const auto may_cover = [&](double height) {
            raise_apex(rim, height, hole);
            const std::vector<Corners> fan = fan_of(hole, rim);
            return !is_folded(fan) && !is_pierced(moved, clusters, solid, hole, fan);
        };
        // Where the faces at a rim bend over, they may miss a fan that rises or sinks.
        constexpr std::array kHeights = {0.0, -0.25, 0.25};
        hole.is_covered = std::ranges::any_of(kHeights, may_cover);
        if (!hole.is_covered) {
            raise_apex(rim, 0, hole);
            hole.bounds.radius *= 1.05;  // so that no corner of the rim is left outside alone
            open.push_back(hole.bounds);
        }
        covered.add(hole, fan_of(hole, rim));
    }
    return covered.is_enough() &&
           (open.empty() || hangs_together_outside(moved, clusters, solid, open));
}

bool may_face(const Hole& hole, std::span<const glm::dvec3> rim_world, const Viewpoint& eye) {
    for (const auto& [a, b, c] : fan_of(hole, rim_world)) {
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const glm::dvec3 way = eye.sight(a);
        // Rounding, and what snapping vertices may turn, is no matter here: a sliver that is seen
        // so nearly edge-on lies within a rounding of a contour.
        if (!(glm::dot(n, way) > 1e-12 * glm::length(n) * glm::length(way))) return true;
    }
    return false;
}

}  // namespace ink::scene
