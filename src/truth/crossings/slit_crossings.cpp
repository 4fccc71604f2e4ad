#include "truth/crossings/slit_crossings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace ink::truth {
namespace {

double distance_to_edge(const scene::Topology& topology, std::uint32_t e, const glm::dvec3& p) {
    const glm::dvec3 a = topology.p_world[topology.edges[e].a];
    const glm::dvec3 ab = topology.p_world[topology.edges[e].b] - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

/// How far a crossing runs from an edge: both its ends, so all of it. Infinity where the edge is no
/// border.
double distance_along(const scene::Topology& topology, std::uint32_t e, const Crossing& crossing) {
    if (topology.edges[e].face_count != 1) return std::numeric_limits<double>::infinity();
    return std::max(distance_to_edge(topology, e, crossing.begin_world),
                    distance_to_edge(topology, e, crossing.end_world));
}

/// Into a face from its side i, orthogonal to it.
glm::dvec3 inward(const scene::Topology& topology, const scene::Face& face, std::size_t i) {
    const glm::dvec3 a = topology.p_world[face.vertices[i]];
    const glm::dvec3 along = topology.p_world[face.vertices[(i + 1) % 3]] - a;
    const glm::dvec3 to_opposite = topology.p_world[face.vertices[(i + 2) % 3]] - a;
    return to_opposite - along * (glm::dot(along, to_opposite) / glm::dot(along, along));
}

/// How far the crossing runs from a border of either face, if that is within two tolerances and the
/// faces lie to different sides of it, flatter than a crease; else infinity.
double slit(const scene::Topology& topology,
            const ContinuationOptions& options,
            const Crossing& crossing) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const scene::Face& f0 = topology.faces[crossing.face0];
    const scene::Face& f1 = topology.faces[crossing.face1];
    if (f0.object != f1.object) return kNone;
    const double reach = 2 * options.tolerances[f0.object];
    for (std::size_t i = 0; i < 3; ++i) {
        const double from0 = distance_along(topology, f0.edges[i], crossing);
        if (from0 > reach) continue;
        const glm::dvec3 into0 = inward(topology, f0, i);
        for (std::size_t k = 0; k < 3; ++k) {
            const double from1 = distance_along(topology, f1.edges[k], crossing);
            if (from1 > reach) continue;
            const glm::dvec3 into1 = inward(topology, f1, k);
            const double angle =
                std::atan2(glm::length(glm::cross(into0, into1)), glm::dot(into0, into1));
            if (std::numbers::pi - angle < options.crease_rad) return std::max(from0, from1);
        }
    }
    return kNone;
}

}  // namespace

void mark_slit_crossings(const scene::Topology& topology,
                         const ContinuationOptions& options,
                         std::vector<Crossing>& crossings) {
    for (Crossing& crossing : crossings)
        crossing.slit_world = slit(topology, options, crossing);
}

}  // namespace ink::truth
