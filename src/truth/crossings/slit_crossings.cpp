#include "truth/crossings/slit_crossings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ink::truth {
namespace {

double distance_to_edge(const scene::Topology& topology, std::uint32_t e, const glm::dvec3& p) {
    const glm::dvec3 a = topology.p_world[topology.edges[e].a];
    const glm::dvec3 ab = topology.p_world[topology.edges[e].b] - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

/// Whether an edge is a border that a crossing runs along: both its ends, so all of it.
bool runs_along(const scene::Topology& topology,
                std::uint32_t e,
                const Crossing& crossing,
                double reach) {
    return topology.edges[e].face_count == 1 &&
           distance_to_edge(topology, e, crossing.begin_world) <= reach &&
           distance_to_edge(topology, e, crossing.end_world) <= reach;
}

/// Into a face from its side i, orthogonal to it.
glm::dvec3 inward(const scene::Topology& topology, const scene::Face& face, std::size_t i) {
    const glm::dvec3 a = topology.p_world[face.vertices[i]];
    const glm::dvec3 along = topology.p_world[face.vertices[(i + 1) % 3]] - a;
    const glm::dvec3 to_opposite = topology.p_world[face.vertices[(i + 2) % 3]] - a;
    return to_opposite - along * (glm::dot(along, to_opposite) / glm::dot(along, along));
}

/// Whether the crossing runs along a border of either face, from which the faces lie to different
/// sides, flatter than a crease.
bool is_slit(const scene::Topology& topology,
             const ContinuationOptions& options,
             const Crossing& crossing) {
    const double reach = 2 * options.tolerance;
    const scene::Face& f0 = topology.faces[crossing.face0];
    const scene::Face& f1 = topology.faces[crossing.face1];
    for (std::size_t i = 0; i < 3; ++i) {
        if (!runs_along(topology, f0.edges[i], crossing, reach)) continue;
        const glm::dvec3 into0 = inward(topology, f0, i);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!runs_along(topology, f1.edges[k], crossing, reach)) continue;
            const glm::dvec3 into1 = inward(topology, f1, k);
            const double angle =
                std::atan2(glm::length(glm::cross(into0, into1)), glm::dot(into0, into1));
            if (std::numbers::pi - angle < options.crease_rad) return true;
        }
    }
    return false;
}

}  // namespace

void drop_slit_crossings(const scene::Topology& topology,
                         const ContinuationOptions& options,
                         std::vector<Crossing>& crossings) {
    std::erase_if(crossings, [&](const Crossing& crossing) {
        return topology.faces[crossing.face0].object == topology.faces[crossing.face1].object &&
               is_slit(topology, options, crossing);
    });
}

}  // namespace ink::truth
