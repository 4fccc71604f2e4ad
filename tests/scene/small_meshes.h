#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/scene.h"

/// Scenes whose counts fit in a head.
namespace ink::scene {

/// The cube [-1, 1]^3 as twelve outward triangles on eight vertices.
inline Mesh unit_cube() {
    Mesh mesh;
    mesh.name = "cube";
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    const std::uint32_t quads[][4] = {
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : quads)
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    return mesh;
}

/// Adds the parallelogram between p + u and p + v as two triangles.
inline void add_quad(Mesh& mesh, const glm::vec3& p, const glm::vec3& u, const glm::vec3& v) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {p, p + u, p + u + v, p + v});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// `mesh` placed once, untransformed.
inline Scene scene_of(Mesh mesh) {
    Scene scene;
    scene.name = mesh.name;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({0, glm::dmat4(1), "only"});
    return scene;
}

/// A scene and a view of it, turned together about the origin.
struct Turned {
    Scene scene;
    View view;

    Turned(Scene of, const View& seen, const glm::dmat4& turn) : scene(std::move(of)), view(seen) {
        for (Instance& instance : scene.instances)
            instance.world_from_object = turn * instance.world_from_object;
        view.camera.eye_world = turn * glm::dvec4(seen.camera.eye_world, 1);
        view.camera.view_from_world =
            seen.camera.view_from_world * glm::transpose(glm::dmat3(turn));
        view.camera.sight_world = {};
    }
};

/// One object per mesh, each where it is.
inline Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    for (std::uint32_t i = 0; i < meshes.size(); ++i)
        scene.instances.push_back({i, glm::dmat4(1), "object"});
    scene.meshes = std::move(meshes);
    return scene;
}

/// So many times the triangle (0,0,0) (1,0,0) (0,1,0), with normals along z.
inline Scene small_triangles(std::size_t count) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    return scene_of(std::vector<Mesh>(count, mesh));
}

/// Without the faces whose middle lies within `radius` of one of the points.
inline Mesh without(Mesh mesh, const std::vector<glm::dvec3>& points, double radius) {
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        const glm::dvec3 middle =
            glm::dvec3(mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0;
        return std::any_of(points.begin(), points.end(), [&](const glm::dvec3& p) {
            return glm::distance(p, middle) < radius;
        });
    });
    return mesh;
}

/// Every triangle with three vertices of its own, as STL and OBJ arrive.
inline Mesh exploded(const Mesh& mesh) {
    Mesh soup;
    soup.name = mesh.name;
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (const std::uint32_t v : t)
            soup.positions.push_back(mesh.positions[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

}  // namespace ink::scene
