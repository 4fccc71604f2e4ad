#include "truth/slit_crossings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::truth {
namespace {

double distance_to_edge(const scene::Topology& topology, std::uint32_t e, const glm::dvec3& p) {
    const glm::dvec3 a = topology.p_world[topology.edges[e].a];
    const glm::dvec3 ab = topology.p_world[topology.edges[e].b] - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

bool is_at_border(const scene::Topology& topology,
                  std::uint32_t face,
                  const glm::dvec3& p,
                  double reach) {
    const auto& edges = topology.faces[face].edges;
    return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t e) {
        return topology.edges[e].face_count == 1 && distance_to_edge(topology, e, p) <= reach;
    });
}

/// The angle between two planes, 0..pi/2.
double angle_between_planes(const scene::Topology& topology, const Crossing& crossing) {
    const auto normal = [&](std::uint32_t face) {
        const auto& v = topology.faces[face].vertices;
        const auto& p = topology.p_world;
        return glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
    };
    const glm::dvec3 n0 = normal(crossing.face0), n1 = normal(crossing.face1);
    return std::atan2(glm::length(glm::cross(n0, n1)), std::abs(glm::dot(n0, n1)));
}

}  // namespace

void drop_slit_crossings(const scene::Topology& topology,
                         const ContinuationOptions& options,
                         std::vector<Crossing>& crossings) {
    const double reach = 2 * options.tolerance;
    std::erase_if(crossings, [&](const Crossing& crossing) {
        if (topology.faces[crossing.face0].object != topology.faces[crossing.face1].object)
            return false;
        for (const std::uint32_t face : {crossing.face0, crossing.face1}) {
            if (!is_at_border(topology, face, crossing.begin_world, reach) ||
                !is_at_border(topology, face, crossing.end_world, reach))
                return false;
        }
        return angle_between_planes(topology, crossing) < options.crease_rad;
    });
}

}  // namespace ink::truth
