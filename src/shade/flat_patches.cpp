#include "shade/flat_patches.h"

#include <glm/geometric.hpp>

#include "core/disjoint_sets.h"
#include "scene/topology.h"

namespace ink::shade {
namespace {

/// Whether the face runs from `from` to `to` at one of its edges.
bool runs(const scene::Face& face, std::uint32_t from, std::uint32_t to) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.vertices[i] == from && face.vertices[(i + 1) % 3] == to) return true;
    }
    return false;
}

/// Two faces that run through the edge in opposite directions: what a surface goes on over.
bool goes_on(const scene::Topology& topology, const scene::Edge& edge) {
    if (edge.face_count != 2) return false;
    const auto faces = topology.faces_of(edge);
    return runs(topology.faces[faces[0]], edge.a, edge.b) !=
           runs(topology.faces[faces[1]], edge.a, edge.b);
}

/// Sums weighted by area: of what a spot is made.
struct PatchSum {
    glm::dvec3 p_world{0};
    glm::dvec3 n_world{0};
    double area = 0;
};

UniformSpots::Spot to_spot(const PatchSum& sum) {
    UniformSpots::Spot spot;
    if (sum.area > 0) spot.p_world = sum.p_world / sum.area;
    const double length = glm::length(sum.n_world);
    if (length > 0) spot.n_world = sum.n_world / length;
    return spot;
}

void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, PatchSum& sum) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::length(n);
    sum.p_world += area / 3 * (a + b + c);
    sum.n_world += n;
    sum.area += area;
}

}  // namespace

UniformSpots face_spots(const scene::Surface& surface) {
    UniformSpots result;
    for (const auto& [a, b, c] : surface.triangles) {
        PatchSum sum;
        add_triangle(surface.p_world[a], surface.p_world[b], surface.p_world[c], sum);
        result.of.push_back(static_cast<std::uint32_t>(result.spots.size()));
        result.spots.push_back(to_spot(sum));
    }
    return result;
}

UniformSpots patch_spots(const scene::Scene& scene, double crease_rad) {
    const scene::Topology topology = scene::weld(scene);
    core::DisjointSets groups(topology.faces.size());
    std::vector<std::uint32_t> smooth;  // a face at each edge beyond which the surface bends on
    for (const scene::Edge& edge : topology.edges) {
        if (!goes_on(topology, edge)) continue;
        const auto faces = topology.faces_of(edge);
        const double deviation = scene::deviation_rad(topology, edge, faces[0], faces[1]);
        if (deviation < kFlat_rad) {
            groups.join(faces[0], faces[1]);
        } else if (deviation < crease_rad) {
            smooth.insert(smooth.end(), faces.begin(), faces.end());
        }
    }
    std::vector<bool> is_curved(topology.faces.size());
    for (const std::uint32_t face : smooth)
        is_curved[groups.root(face)] = true;

    UniformSpots result;
    result.of.assign(scene::triangle_count(scene), UniformSpots::kNone);
    std::vector<std::uint32_t> patch_of(topology.faces.size(), UniformSpots::kNone);
    std::vector<PatchSum> sums;
    for (std::uint32_t i = 0; i < topology.faces.size(); ++i) {
        const std::uint32_t root = groups.root(i);
        if (is_curved[root]) continue;
        if (patch_of[root] == UniformSpots::kNone) {
            patch_of[root] = static_cast<std::uint32_t>(sums.size());
            sums.emplace_back();
        }
        const scene::Face& face = topology.faces[i];
        const auto& p = topology.p_world;
        add_triangle(
            p[face.vertices[0]], p[face.vertices[1]], p[face.vertices[2]], sums[patch_of[root]]);
        result.of[face.triangle] = patch_of[root];
    }
    for (const PatchSum& sum : sums)
        result.spots.push_back(to_spot(sum));
    return result;
}

}  // namespace ink::shade
