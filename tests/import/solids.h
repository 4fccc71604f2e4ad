#pragma once

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::import {

/// What is left of triangles to be compared: their bounds and what they enclose.
struct Solid {
    glm::dvec3 low{1e300};
    glm::dvec3 high{-1e300};
    double volume = 0;
};

/// Of every three corners a triangle.
inline Solid solid_of(const std::vector<glm::dvec3>& corners) {
    Solid solid;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        solid.volume += glm::dot(corners[i], glm::cross(corners[i + 1], corners[i + 2])) / 6;
    for (const glm::dvec3& p : corners) {
        solid.low = glm::min(solid.low, p);
        solid.high = glm::max(solid.high, p);
    }
    return solid;
}

/// Every corner of every triangle where the file has it, in order: of the instances of this name,
/// or of all.
inline std::vector<glm::dvec3> corners_of(const scene::Scene& scene, const std::string& name = {}) {
    std::vector<glm::dvec3> corners;
    for (const scene::Instance& instance : scene.instances) {
        if (!name.empty() && instance.name != name) continue;
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        for (const scene::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t v : triangle)
                corners.push_back(scene.origin + scene::to_world(instance, mesh.positions[v]));
    }
    return corners;
}

inline Solid solid_of(const scene::Scene& scene, const std::string& name = {}) {
    return solid_of(corners_of(scene, name));
}

inline void expect_box(const Solid& solid,
                       const glm::dvec3& low,
                       const glm::dvec3& high,
                       double within = 1e-6) {
    EXPECT_LT(glm::length(solid.low - low), within)
        << solid.low.x << ' ' << solid.low.y << ' ' << solid.low.z;
    EXPECT_LT(glm::length(solid.high - high), within)
        << solid.high.x << ' ' << solid.high.y << ' ' << solid.high.z;
}

inline void expect_solid(const scene::Scene& scene,
                         const glm::dvec3& low,
                         const glm::dvec3& high,
                         double volume) {
    const Solid solid = solid_of(scene);
    expect_box(solid, low, high, 1e-5);
    EXPECT_NEAR(solid.volume, volume, 1e-5);
}

}  // namespace ink::import
