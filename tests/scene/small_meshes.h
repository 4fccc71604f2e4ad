#pragma once

#include <glm/gtc/matrix_transform.hpp>

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
    mesh.triangles = {{0, 2, 3},
                      {0, 3, 1},
                      {4, 5, 7},
                      {4, 7, 6},
                      {0, 1, 5},
                      {0, 5, 4},
                      {2, 6, 7},
                      {2, 7, 3},
                      {0, 4, 6},
                      {0, 6, 2},
                      {1, 3, 7},
                      {1, 7, 5}};
    return mesh;
}

/// `mesh` placed once, untransformed.
inline Scene scene_of(Mesh mesh) {
    Scene scene;
    scene.name = mesh.name;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({0, glm::dmat4(1), "only"});
    return scene;
}

/// One object per mesh, each where it is.
inline Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    for (std::uint32_t i = 0; i < meshes.size(); ++i)
        scene.instances.push_back({i, glm::dmat4(1), "object"});
    scene.meshes = std::move(meshes);
    return scene;
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
