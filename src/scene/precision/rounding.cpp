#include "scene/precision/rounding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/predicates.h"

namespace ink::scene {
namespace {

constexpr double kMostDoubt_rad = 1e-3;
constexpr double kArithmetic_rad = 16 * std::numeric_limits<double>::epsilon();

double area(const RoundedPoint& a, const RoundedPoint& b, const RoundedPoint& c) {
    return glm::length(glm::cross(b.p - a.p, c.p - a.p));
}

/// The same of a face about one of its edges.
double turning_doubt_rad(const Topology& topology, const Edge& edge, std::uint32_t face) {
    const std::uint32_t opposite = opposite_vertex(topology.faces[face], edge);
    return turning_doubt_rad(rounded_point(topology, edge.a),
                             rounded_point(topology, edge.b),
                             rounded_point(topology, opposite));
}

}  // namespace

double half_ulp(const glm::vec3& p) {
    const float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return (static_cast<double>(std::nextafter(largest, std::numeric_limits<float>::infinity())) -
            static_cast<double>(largest)) /
           2;
}

double most_rounding_px(const Topology& topology, const View& view) {
    const Projection projection(view);
    double most_px = 0;
    for (std::size_t v = 0; v < topology.p_world.size(); ++v) {
        const glm::dvec3 p_clip = projection.to_clip(topology.p_world[v]);
        const double w = p_clip.z;
        const bool is_in_frame = w > view.camera.near && p_clip.x >= 0 && p_clip.y >= 0 &&
                                 p_clip.x <= view.width_px * w && p_clip.y <= view.height_px * w;
        if (!is_in_frame) continue;
        most_px = std::max(most_px, topology.rounding_world[v] * projection.px_per_world(w));
    }
    return most_px;
}

double orient3d_doubt(const RoundedPoint& a,
                      const RoundedPoint& b,
                      const RoundedPoint& c,
                      const RoundedPoint& d) {
    return a.rounding * area(b, c, d) + b.rounding * area(a, c, d) + c.rounding * area(a, b, d) +
           d.rounding * area(a, b, c);
}

int sure_orient3d(const RoundedPoint& a,
                  const RoundedPoint& b,
                  const RoundedPoint& c,
                  const RoundedPoint& d) {
    const double value = orient3d_value(a.p, b.p, c.p, d.p);
    if (std::abs(value) <= orient3d_doubt(a, b, c, d)) return 0;
    return value > 0 ? 1 : -1;
}

int sure_facing(const RoundedPoint& a,
                const RoundedPoint& b,
                const RoundedPoint& c,
                const Viewpoint& eye) {
    if (!eye.is_direction) return -sure_orient3d(a, b, c, {eye.at_world, 0});
    // Each corner moves the volume by the area that the direction and the side opposite span.
    const double doubt = a.rounding * glm::length(eye.plane(b.p, c.p)) +
                         b.rounding * glm::length(eye.plane(a.p, c.p)) +
                         c.rounding * glm::length(eye.plane(a.p, b.p));
    const double value = glm::dot(eye.plane(a.p, b.p), c.p - a.p);
    return std::abs(value) <= doubt ? 0 : facing(a.p, b.p, c.p, eye);
}

double turning_doubt_rad(const RoundedPoint& a, const RoundedPoint& b, const RoundedPoint& c) {
    const glm::dvec3 along = b.p - a.p;
    const double length2 = glm::dot(along, along);
    const double t = glm::dot(c.p - a.p, along) / length2;
    const double height = area(a, b, c) / std::sqrt(length2);
    // What moves the corner, and the side below it, over the height.
    return (c.rounding + std::abs(1 - t) * a.rounding + std::abs(t) * b.rounding) / height;
}

bool is_crease(double deviation_rad, double doubt_rad, double crease_rad) {
    if (deviation_rad >= crease_rad) return true;
    const double doubt = doubt_rad + kArithmetic_rad;
    return doubt <= kMostDoubt_rad && deviation_rad + doubt >= crease_rad;
}

bool is_crease(const Topology& topology,
               const Edge& edge,
               std::uint32_t face0,
               std::uint32_t face1,
               double crease_rad) {
    const double deviation = deviation_rad(topology, edge, face0, face1);
    if (deviation + kMostDoubt_rad < crease_rad) return false;
    const double doubt =
        turning_doubt_rad(topology, edge, face0) + turning_doubt_rad(topology, edge, face1);
    return is_crease(deviation, doubt, crease_rad);
}

}  // namespace ink::scene
