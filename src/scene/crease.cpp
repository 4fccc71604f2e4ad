#include "scene/crease.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "core/error.h"
#include "scene/precision/rounding.h"

namespace ink::scene {

namespace {

bool is_marked(const Face& face, const Edge& edge) {
    const std::uint32_t side = side_opposite(face, opposite_vertex(face, edge));
    return (face.marked_sides >> side & 1U) != 0;
}

/// Whether the two faces are all that one object has at the edge.
bool are_one_object(const Topology& topology, const Edge& edge, const Face& f, const Face& g) {
    const auto all = topology.faces_of(edge);
    return f.object == g.object && std::ranges::count_if(all, [&](std::uint32_t other) {
                                       return topology.faces[other].object == f.object;
                                   }) == 2;
}

}  // namespace

bool is_crease(const Topology& topology,
               const Edge& edge,
               std::uint32_t face0,
               std::uint32_t face1,
               const CreaseRule& rule) {
    const Face &f = topology.faces[face0], &g = topology.faces[face1];
    if (rule.source == CreaseSource::file && are_one_object(topology, edge, f, g))
        return is_marked(f, edge) || is_marked(g, edge);
    return is_crease(topology, edge, face0, face1, rule.angle_rad);
}

CreaseProposal propose_crease(const Topology& topology) {
    constexpr std::size_t kLeast_deg = 8, kMost_deg = 60;
    constexpr double kUsual_deg = 40, kShare = 0.01;
    const auto radians = [](double deg) { return deg * std::numbers::pi / 180; };
    // The length of what bends by 1 degree or more and less than so many.
    std::array<double, 181> below{};
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const auto faces = topology.faces_of(edge);
        const double bend_rad = deviation_rad(topology, edge, faces[0], faces[1]);
        const auto bend_deg = static_cast<std::size_t>(bend_rad * 180 / std::numbers::pi);
        if (bend_deg == 0) continue;
        below[std::min<std::size_t>(bend_deg, 179) + 1] +=
            glm::length(topology.p_world[edge.b] - topology.p_world[edge.a]);
    }
    std::partial_sum(below.begin(), below.end(), below.begin());
    const double most = kShare * below.back();
    CreaseProposal best{radians(kUsual_deg), radians(kUsual_deg), radians(kUsual_deg)};
    for (std::size_t from = kLeast_deg; from < kMost_deg; ++from) {
        if (below[from] <= most) continue;
        std::size_t to = from;
        while (to < kMost_deg && below[to + 1] - below[from] <= most)
            ++to;
        const auto low = static_cast<double>(from), high = static_cast<double>(to);
        if (high / low <= best.to_rad / best.from_rad) continue;
        best = {radians(std::round(std::sqrt(low * high))), radians(low), radians(high)};
    }
    return best;
}

void check_creases(const Scene& scene, CreaseSource source) {
    const bool has_marks = std::ranges::any_of(
        scene.meshes, [](const Mesh& mesh) { return !mesh.marked_sides.empty(); });
    if (source != CreaseSource::file || has_marks) return;
    throw core::Error(scene.name,
                      "it marks no edges, so creases cannot be those of its file",
                      "--creases angle, or a glTF file with EXT_mesh_primitive_edge_visibility");
}

}  // namespace ink::scene
