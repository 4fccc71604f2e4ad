#include "truth/crossings/triangle_distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ink::truth {
namespace {

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(p - (a + t * along));
}

}  // namespace

double distance_to_triangle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 u = b - a, v = c - a, d = p - a;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
    const double du = glm::dot(d, u), dv = glm::dot(d, v);
    const double area2 = uu * vv - uv * uv;
    const double s = vv * du - uv * dv, t = uu * dv - uv * du;
    const double on_border = std::min(
        {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
    if (!(area2 > 0) || s < 0 || t < 0 || s + t > area2) return on_border;
    return std::min(on_border, glm::length(d - (s * u + t * v) / area2));
}

}  // namespace ink::truth
