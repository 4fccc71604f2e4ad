#include "scene/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kCrease_rad = 40 * std::numbers::pi / 180;

TEST(PatchNormals, CubeGetsOneVertexPerCornerAndSide) {
    const Surface surface = flatten(scene_of(unit_cube()), NormalSource::patch, kCrease_rad);
    EXPECT_EQ(surface.p_world.size(), 24U);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const glm::dvec3 n = glm::normalize(glm::cross(surface.p_world[b] - surface.p_world[a],
                                                       surface.p_world[c] - surface.p_world[a]));
        for (const std::uint32_t v : {a, b, c}) {
            EXPECT_LT(glm::length(n - glm::dvec3(surface.n_world[v])), 1e-6);
        }
    }
}

TEST(PatchNormals, WithoutCreasesTheCubeIsSmoothAndItsNormalsAreDiagonals) {
    const Surface surface = flatten(scene_of(unit_cube()), NormalSource::patch, 3.0);
    ASSERT_EQ(surface.p_world.size(), 8U);
    for (std::size_t v = 0; v < 8; ++v) {
        // Weighted by corner angle, so that the two triangles of a square count as one.
        EXPECT_LT(glm::length(glm::normalize(surface.p_world[v]) - glm::dvec3(surface.n_world[v])),
                  1e-6);
    }
}

TEST(FileNormals, OfAMirroredInstanceStillPointOutward) {
    Scene scene = scene_of(unit_cube());
    for (const glm::vec3& p : scene.meshes[0].positions) {
        scene.meshes[0].normals.push_back(glm::normalize(p));
    }
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(-2, 1, 1));
    const Surface surface = flatten(scene, NormalSource::file, kCrease_rad);
    for (std::size_t v = 0; v < surface.p_world.size(); ++v) {
        EXPECT_GT(glm::dot(surface.p_world[v], glm::dvec3(surface.n_world[v])), 0);
    }
}

TEST(Flatten, KeepsTheGlobalTriangleIndexOverDroppedTriangles) {
    Mesh mesh = unit_cube();
    mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 0, 1});
    mesh.triangles.push_back(mesh.triangles[1]);
    const Scene scene = scene_of(mesh);
    for (const auto source : {NormalSource::patch, NormalSource::facet, NormalSource::file}) {
        const Surface surface = flatten(scene, source, kCrease_rad);
        ASSERT_EQ(surface.triangles.size(), 14U);
        const auto& [a, b, c] = surface.triangles[1];
        EXPECT_EQ(surface.p_world[a], glm::dvec3(mesh.positions[mesh.triangles[1][0]]));
        EXPECT_EQ(surface.p_world[b], glm::dvec3(mesh.positions[mesh.triangles[1][1]]));
        EXPECT_EQ(surface.p_world[c], glm::dvec3(mesh.positions[mesh.triangles[1][2]]));
    }
}

}  // namespace
}  // namespace ink::scene
