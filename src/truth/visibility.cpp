#include "truth/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/predicates.h"

namespace ink::truth {
namespace {

constexpr double kBeside = 1.0 / 2048;  ///< px; design, section 5

// How far past the point candidates are taken: the distance that Embree finds for a triangle seen
// at a grazing angle g is off by about 1e-7/sin(g), so this loses none above a thousandth of a
// degree. Those taken in vain cost a predicate each.
constexpr double kPast = 1.0 / 64;

}  // namespace

bool Visibility::is_own(std::uint32_t face, std::uint32_t edge) const {
    const auto& edges = eye_.model.topology.faces[face].edges;
    return edges[0] == edge || edges[1] == edge || edges[2] == edge;
}

/// The side of the face's plane on which the point lies, exact for the true point of the edge: if
/// both ends lie on one side so does it, whatever rounding did to its coordinates.
int Visibility::side_of_point(std::uint32_t f, const EdgePoint& point) const {
    const scene::Topology& topology = eye_.model.topology;
    const auto& p = topology.p_world;
    const scene::Edge& edge = topology.edges[point.edge];
    const auto& v = topology.faces[f].vertices;
    const auto side = [&](std::uint32_t end) {
        if (end == v[0] || end == v[1] || end == v[2]) return 0;
        return scene::facing(p[v[0]], p[v[1]], p[v[2]], p[end]);
    };
    const int side_a = side(edge.a);
    const int side_b = side(edge.b);
    if (side_a * side_b >= 0) return side_a + side_b > 0 ? 1 : side_a + side_b < 0 ? -1 : 0;
    return scene::facing(p[v[0]], p[v[1]], p[v[2]], point.p_world);
}

/// Whether the line from the eye through the point meets the closed triangle; one seen edge-on is
/// never met.
bool Visibility::pierces(std::uint32_t f, const EdgePoint& point) const {
    const auto& p = eye_.model.topology.p_world;
    const auto& v = eye_.model.topology.faces[f].vertices;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int s = scene::orient3d(eye_.eye_world(), point.p_world, p[v[i]], p[v[(i + 1) % 3]]);
        low = std::min(low, s);
        high = std::max(high, s);
        if (low < 0 && high > 0) return false;
    }
    return low != high;
}

/// Whether the line of sight meets the face's plane in front of the near plane.
bool Visibility::is_cut_away(std::uint32_t f, const EdgePoint& point) const {
    const auto& v = eye_.model.topology.faces[f].vertices;
    const auto is_near = [&](std::uint32_t i) { return eye_.p_clip[i].z < eye_.near; };
    if (!is_near(v[0]) && !is_near(v[1]) && !is_near(v[2])) return false;
    const auto& p = eye_.model.topology.p_world;
    const glm::dvec3 normal = glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
    const double along = glm::dot(normal, point.p_world - eye_.eye_world());
    const double t = glm::dot(normal, p[v[0]] - eye_.eye_world()) / along;
    return t * point.w < eye_.near;
}

bool Visibility::blocks(std::uint32_t f, const EdgePoint& point) const {
    const int side_eye = eye_.facing[f];
    if (side_eye == 0 || is_own(f, point.edge)) return false;
    return side_of_point(f, point) * side_eye < 0 && pierces(f, point) && !is_cut_away(f, point);
}

/// Beyond the point, or touching it there as the floor touches a box that stands on it.
bool Visibility::is_behind(std::uint32_t f, const EdgePoint& point) const {
    const int side_eye = eye_.facing[f];
    if (side_eye == 0 || is_own(f, point.edge)) return false;
    return side_of_point(f, point) * side_eye >= 0 && pierces(f, point);
}

bool Visibility::is_visible(const EdgePoint& point,
                            std::uint32_t& blocker,
                            std::size_t& rays) const {
    if (blocker != kNoFace && blocks(blocker, point)) return false;
    const auto confirm = [&](std::uint32_t face) {
        if (!blocks(face, point)) return false;
        blocker = face;
        return true;
    };
    const glm::dvec3 to_point = point.p_world - eye_.eye_world();
    const double t_near = 0.99 * eye_.near / point.w;
    ++rays;
    if (scene_.any({to_point, t_near, 1 + kPast}, confirm)) return false;
    // Row vector times rotation: view space back to world.
    const double beside = kBeside * point.w / eye_.projection.focal_px();
    const glm::dvec3 right = glm::dvec3(beside, 0, 0) * eye_.view_from_world;
    const glm::dvec3 up = glm::dvec3(0, beside, 0) * eye_.view_from_world;
    rays += 4;
    const std::array<glm::dvec3, 4> directions = {
        to_point + right, to_point - right, to_point + up, to_point - up};
    return !scene_.any_of_four(directions, {t_near, 1 + kPast}, confirm);
}

std::optional<EyeScene::Hit> Visibility::first_behind(const EdgePoint& point,
                                                      std::size_t& rays) const {
    EyeRay ray;
    ray.direction_world = point.p_world - eye_.eye_world();
    ray.t_near = 1 - kPast;
    ray.t_far = std::numeric_limits<double>::infinity();
    ++rays;
    return scene_.first(ray, [&](std::uint32_t face) { return is_behind(face, point); });
}

ContourKind Visibility::kind_behind(const EdgePoint& point, std::size_t& rays) const {
    const auto hit = first_behind(point, rays);
    if (!hit) return ContourKind::sky;
    const scene::Topology& topology = eye_.model.topology;
    const std::uint32_t own = topology.faces_of(topology.edges[point.edge])[0];
    return topology.faces[hit->face].object == topology.faces[own].object
               ? ContourKind::self
               : ContourKind::other_object;
}

}  // namespace ink::truth
