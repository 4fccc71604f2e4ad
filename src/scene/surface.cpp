#include "scene/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/disjoint_sets.h"
#include "scene/precision/rounding.h"
#include "scene/predicates.h"
#include "scene/prepared_scene.h"

namespace ink::scene {
namespace {

/// A triangle of an instance, corners swapped if mirrored.
struct PlacedTriangle {
    std::uint32_t object;
    const Instance& instance;
    const Mesh& mesh;
    Triangle vertices;

    [[nodiscard]] glm::dvec3 corner(std::size_t i) const {
        return to_world(instance, mesh.positions[vertices[i]]);
    }
};

template <class Visit>
void for_each_triangle(const Scene& scene, Visit visit) {
    for (std::uint32_t object = 0; object < scene.instances.size(); ++object) {
        const Instance& instance = scene.instances[object];
        const Mesh& mesh = scene.meshes[instance.mesh];
        const bool mirrored = is_mirrored(instance);
        for (const Triangle& stored : mesh.triangles) {
            Triangle triangle = stored;
            if (mirrored) std::swap(triangle[1], triangle[2]);
            visit(PlacedTriangle{object, instance, mesh, triangle});
        }
    }
}

/// Corner 3f+i of every face, joined across the edges that are smooth: corners of a set share a
/// normal.
core::DisjointSets join_smooth_corners(const Topology& topology, double crease_rad) {
    core::DisjointSets sets(topology.faces.size() * 3);
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 2 || !is_consistent(topology, edge)) continue;
        const auto faces = topology.faces_of(edge);
        if (is_crease(topology, edge, faces[0], faces[1], crease_rad)) continue;
        for (const std::uint32_t v : {edge.a, edge.b}) {
            sets.join(3 * faces[0] + corner_at(topology.faces[faces[0]], v),
                      3 * faces[1] + corner_at(topology.faces[faces[1]], v));
        }
    }
    return sets;
}

double corner_angle_rad(const Topology& topology, const Face& face, std::size_t corner) {
    const glm::dvec3 p = topology.p_world[face.vertices[corner]];
    const glm::dvec3 u = topology.p_world[face.vertices[(corner + 1) % 3]] - p;
    const glm::dvec3 v = topology.p_world[face.vertices[(corner + 2) % 3]] - p;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

glm::vec3 unit_or_z(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
}

Surface patch_surface(const PreparedScene& scene, double crease_rad) {
    const auto welded = scene.topology();
    const Topology& topology = *welded;
    core::DisjointSets sets = join_smooth_corners(topology, crease_rad);

    std::vector<glm::dvec3> sums(topology.faces.size() * 3, glm::dvec3(0));
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        const Face& face = topology.faces[f];
        const glm::dvec3 normal = topology.area_vector(f);
        const glm::dvec3 unit = normal / std::max(glm::length(normal), 1e-300);
        for (std::uint32_t i = 0; i < 3; ++i) {
            sums[sets.root(3 * f + i)] += unit * corner_angle_rad(topology, face, i);
        }
    }

    // Dropped triangles (degenerate, duplicate) keep their index and get corners of their own.
    Surface surface;
    std::vector<std::uint32_t> vertex_of_set(sums.size(), 0xffffffffU);
    std::uint32_t f = 0;
    std::uint32_t triangle_index = 0;
    const auto add_vertex = [&](const glm::dvec3& p, const glm::vec3& n) {
        surface.p_world.push_back(p);
        surface.n_world.push_back(n);
        return static_cast<std::uint32_t>(surface.p_world.size() - 1);
    };
    for_each_triangle(scene, [&](const PlacedTriangle& at) {
        Triangle drawn{};
        const bool kept = f < topology.faces.size() && topology.faces[f].triangle == triangle_index;
        const std::array<glm::dvec3, 3> p = {at.corner(0), at.corner(1), at.corner(2)};
        const glm::vec3 facet = unit_or_z(glm::cross(p[1] - p[0], p[2] - p[0]));
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (!kept) {
                drawn[i] = add_vertex(p[i], facet);
                continue;
            }
            const std::uint32_t set = sets.root(3 * f + i);
            if (vertex_of_set[set] == 0xffffffffU) {
                vertex_of_set[set] = add_vertex(p[i], unit_or_z(sums[set]));
            }
            drawn[i] = vertex_of_set[set];
        }
        if (kept) ++f;
        ++triangle_index;
        surface.triangles.push_back(drawn);
        surface.object.push_back(at.object);
    });
    return surface;
}

/// One corner per triangle and vertex, each with the triangle's own normal.
Surface facet_surface(const Scene& scene) {
    Surface surface;
    for_each_triangle(scene, [&](const PlacedTriangle& at) {
        const auto first = static_cast<std::uint32_t>(surface.p_world.size());
        for (std::size_t i = 0; i < 3; ++i)
            surface.p_world.push_back(at.corner(i));
        const glm::dvec3* p = surface.p_world.data() + first;
        surface.n_world.insert(
            surface.n_world.end(), 3, unit_or_z(glm::cross(p[1] - p[0], p[2] - p[0])));
        surface.triangles.push_back({first, first + 1, first + 2});
        surface.object.push_back(at.object);
    });
    return surface;
}

/// Turns normals as the inverse transpose does, and copes with flat scales: the cofactor matrix,
/// with a mirror's sign taken out again, since outward stays outward.
glm::dmat3 normal_transform(const Instance& instance) {
    const glm::dmat3 m(instance.world_from_object);
    const glm::dmat3 cofactor(
        glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return cofactor * (is_mirrored(instance) ? -1.0 : 1.0);
}

/// Vertices as the meshes have them, placed; normals too where a mesh has them and they are asked
/// for.
Surface mesh_surface(const Scene& scene, bool with_normals) {
    Surface surface;
    std::vector<std::uint32_t> first_vertex;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        first_vertex.push_back(static_cast<std::uint32_t>(surface.p_world.size()));
        for (const glm::vec3& p : mesh.positions)
            surface.p_world.push_back(to_world(instance, p));
        if (!with_normals) continue;
        const glm::dmat3 turn = normal_transform(instance);
        for (const glm::vec3& n : mesh.normals) {
            surface.n_world.push_back(unit_or_z(turn * glm::dvec3(n)));
        }
    }
    for_each_triangle(scene, [&](const PlacedTriangle& at) {
        const std::uint32_t first = first_vertex[at.object];
        const auto& [a, b, c] = at.vertices;
        surface.triangles.push_back({first + a, first + b, first + c});
        surface.object.push_back(at.object);
    });
    return surface;
}

/// File normals where a mesh has them, patch normals where it has none.
Surface file_surface(const PreparedScene& scene, double crease_rad) {
    const bool all = std::ranges::all_of(scene->instances, [&](auto& instance) {
        const Mesh& mesh = scene->meshes[instance.mesh];
        return mesh.normals.size() == mesh.positions.size();
    });
    if (all) return mesh_surface(scene, true);

    Surface surface = patch_surface(scene, crease_rad);
    std::uint32_t triangle_index = 0;
    for_each_triangle(scene, [&](const PlacedTriangle& at) {
        Triangle& drawn = surface.triangles[triangle_index++];
        if (at.mesh.normals.empty()) return;
        const glm::dmat3 turn = normal_transform(at.instance);
        for (std::size_t i = 0; i < 3; ++i) {
            surface.p_world.push_back(surface.p_world[drawn[i]]);
            const glm::dvec3 n(at.mesh.normals[at.vertices[i]]);
            surface.n_world.push_back(unit_or_z(turn * n));
            drawn[i] = static_cast<std::uint32_t>(surface.p_world.size() - 1);
        }
    });
    return surface;
}

}  // namespace

Surface flatten(const Scene& scene) {
    return mesh_surface(scene, false);
}

Surface flatten(const Scene& scene, NormalSource source, double crease_rad) {
    return flatten(PreparedScene(scene), source, crease_rad);
}

Surface flatten(const PreparedScene& scene, NormalSource source, double crease_rad) {
    switch (source) {
        case NormalSource::file:
            return file_surface(scene, crease_rad);
        case NormalSource::patch:
            return patch_surface(scene, crease_rad);
        case NormalSource::facet:
            return facet_surface(scene);
    }
    return {};
}

}  // namespace ink::scene
