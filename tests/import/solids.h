#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "scene/scene.h"

namespace ink::import {

/// What is left of a scene to be compared: its corners' bounds and what it encloses.
struct Solid {
    glm::dvec3 low{1e30};
    glm::dvec3 high{-1e30};
    double volume = 0;
};

inline Solid solid_of(const scene::Scene& scene) {
    Solid solid;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        for (const scene::Triangle& triangle : mesh.triangles) {
            std::array<glm::dvec3, 3> p;
            for (int c = 0; c < 3; ++c) {
                p[c] = scene.origin + scene::to_world(instance, mesh.positions[triangle[c]]);
                solid.low = glm::min(solid.low, p[c]);
                solid.high = glm::max(solid.high, p[c]);
            }
            solid.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
        }
    }
    return solid;
}

}  // namespace ink::import
