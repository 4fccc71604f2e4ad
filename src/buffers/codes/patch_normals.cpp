#include "buffers/codes/patch_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ink::buffers {
namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// Whether a face runs through the `i`-th edge of another in the same direction.
bool is_turned(const scene::Face& face, std::size_t i, const scene::Face& other) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (other.edges[k] == face.edges[i]) return other.vertices[k] == face.vertices[i];
    }
    return false;
}

}  // namespace

std::vector<glm::dvec3> patch_normals(const SmoothMesh& mesh) {
    const scene::Topology& topology = mesh.topology;
    std::vector<glm::dvec3> normals(mesh.face_count());
    for (std::size_t f = 0; f < normals.size(); ++f) {
        const auto& [a, b, c] = topology.faces[f].vertices;
        const glm::dvec3& p = topology.p_world[a];
        normals[f] = unit_or_zero(glm::cross(topology.p_world[b] - p, topology.p_world[c] - p));
    }
    enum : std::uint8_t { unseen, as_it_is, flipped };
    std::vector<std::uint8_t> side(mesh.face_count(), unseen);
    std::vector<std::uint32_t> due;
    for (std::uint32_t first = 0; first < side.size(); ++first) {
        if (side[first] != unseen) continue;
        side[first] = as_it_is;
        due.push_back(first);
        while (!due.empty()) {
            const std::uint32_t f = due.back();
            due.pop_back();
            if (side[f] == flipped) normals[f] = -normals[f];
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t g = mesh.across[3 * f + i];
                if (g == SmoothMesh::kNone || side[g] != unseen) continue;
                const bool turns = is_turned(topology.faces[f], i, topology.faces[g]);
                side[g] = turns == (side[f] == as_it_is) ? flipped : as_it_is;
                due.push_back(g);
            }
        }
    }
    return normals;
}

std::vector<double> fan_spreads(const SmoothMesh& mesh, const std::vector<glm::dvec3>& normals) {
    std::vector<glm::dvec3> means(mesh.fan_count, glm::dvec3(0));
    for (std::size_t corner = 0; corner < mesh.fan_of.size(); ++corner)
        means[mesh.fan_of[corner]] += normals[corner / 3];
    for (glm::dvec3& mean : means)
        mean = unit_or_zero(mean);
    std::vector<double> spreads(mesh.fan_count, 0);
    for (std::size_t corner = 0; corner < mesh.fan_of.size(); ++corner) {
        double& spread = spreads[mesh.fan_of[corner]];
        spread = std::max(spread, glm::length(normals[corner / 3] - means[mesh.fan_of[corner]]));
    }
    return spreads;
}

}  // namespace ink::buffers
