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

}  // namespace ink::scene
