#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "scene/precision/rounding.h"
#include "truth/visibility.h"

// Of a point of a crossing: which faces lie in its line, and which of those are seen.

namespace ink::truth {

/// How far the point may lie off a face that it lies in: of one that coincides with one of the two
/// that cross, as far as rounding may have moved them; of others, what computing it lost.
double Visibility::doubt_of(std::uint32_t f, const LinePoint& point) const {
    const Crossing& crossing = *point.crossing;
    const bool is_one_of_two = is_coplanar(f, crossing.face0) || is_coplanar(f, crossing.face1);
    return is_one_of_two ? point.doubt_world + eye_.model.topology.rounding_of(f) : crossing.error;
}

/// The side where the true point lies for sure, else 0.
int Visibility::side_of_crossing(std::uint32_t f, const LinePoint& point) const {
    const auto& p = eye_.model.topology.p_world;
    const auto& v = eye_.model.topology.faces[f].vertices;
    const glm::dvec3 u0 = p[v[1]] - p[v[0]], u1 = p[v[2]] - p[v[0]];
    const glm::dvec3 normal = glm::cross(u0, u1);
    const glm::dvec3 d = point.p_world - p[v[0]];
    const double height = glm::dot(normal, d);
    const double noise = point.noise_world * glm::length(normal) +
                         kRounding * glm::length(u0) * glm::length(u1) * glm::length(d);
    const auto is_off = [&](double off) {
        return std::abs(height) > off * glm::length(normal) + noise;
    };
    const int side = height > 0 ? 1 : -1;
    if (is_off(point.doubt_world + eye_.model.topology.rounding_of(f))) return side;
    return is_off(doubt_of(f, point)) ? side : 0;
}

bool Visibility::is_coplanar(std::uint32_t face0, std::uint32_t face1) const {
    const auto& v = eye_.model.topology.faces[face0].vertices;
    const auto& w = eye_.model.topology.faces[face1].vertices;
    const auto point = [&](std::uint32_t i) {
        return scene::rounded_point(eye_.model.topology, i);
    };
    return std::ranges::all_of(w, [&](std::uint32_t i) {
        return scene::sure_orient3d(point(v[0]), point(v[1]), point(v[2]), point(i)) == 0;
    });
}

/// Whether a face through the line of a crossing is seen there, to either side of it, in place of
/// the one of the two that is nearer on that side.
bool Visibility::covers(std::uint32_t f, const LinePoint& point) const {
    const Crossing& crossing = *point.crossing;
    const auto& p = eye_.model.topology.p_world;
    const glm::dvec3 sight = eye_.eye().sight(point.p_world);
    const glm::dvec3 beside = glm::cross(crossing.end_world - crossing.begin_world, sight);
    // How much nearer the plane comes for each step to that side; on the other it recedes so.
    const auto nearing = [&](std::uint32_t face) {
        const glm::dvec3 normal = eye_.model.topology.area_vector(face);
        return glm::dot(normal, beside) / glm::dot(normal, sight);
    };
    std::uint32_t low = crossing.face0, high = crossing.face1;
    if (nearing(high) < nearing(low)) std::swap(low, high);
    const double own = nearing(f);
    // A face that ends at the line covers it to its own side alone.
    const auto& v = eye_.model.topology.faces[f].vertices;
    double least = 0, most = 0;
    for (const std::uint32_t i : v) {
        const double off = point.doubt_world + eye_.model.topology.rounding_world[i];
        const double side = glm::dot(beside, p[i] - point.p_world);
        if (std::abs(side) <= off * glm::length(beside)) continue;
        least = std::min(least, side);
        most = std::max(most, side);
    }
    const auto is_over = [&](std::uint32_t seen, bool is_nearer) {
        return is_coplanar(f, seen) ? f < seen : is_nearer;
    };
    return (least < 0 && is_over(low, own < nearing(low))) ||
           (most > 0 && is_over(high, own > nearing(high)));
}

}  // namespace ink::truth
