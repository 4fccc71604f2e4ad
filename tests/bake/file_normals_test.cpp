#include "bake/bake.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"

namespace ink::bake {
namespace {

/// A scene of a mesh without normals.
scene::Scene bare(scene::Mesh mesh) {
    mesh.normals.clear();
    scene::Scene scene;
    scene.meshes = {std::move(mesh)};
    scene.instances.resize(1);
    return scene;
}

TEST(FileNormals, ACreasePartsThemAndTrianglesStay) {
    const scene::Scene before = bare(catalogue::make_box({0, 0, 0}, {1, 2, 3}));
    scene::Scene after = before;
    add_normals(after, 40);
    const scene::Mesh& old = before.meshes[0];
    const scene::Mesh& mesh = after.meshes[0];
    EXPECT_EQ(mesh.positions.size(), 24U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.triangles.size(), old.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const glm::vec3 normal = glm::normalize(glm::cross(mesh.positions[b] - mesh.positions[a],
                                                           mesh.positions[c] - mesh.positions[a]));
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t corner = mesh.triangles[t][i];
            EXPECT_EQ(mesh.positions[corner], old.positions[old.triangles[t][i]]);
            EXPECT_NEAR(glm::dot(mesh.normals[corner], normal), 1, 1e-6);
        }
    }
}

TEST(FileNormals, ACopyHasItsVertexsTextureCoordinates) {
    scene::Scene scene = bare(catalogue::make_box({0, 0, 0}, {1, 2, 3}));
    std::vector<std::vector<glm::vec2>> texcoords(1);
    for (const glm::vec3& p : scene.meshes[0].positions)
        texcoords[0].emplace_back(p.x + 10 * p.y, p.z);
    add_normals(scene, 40, texcoords);
    ASSERT_EQ(texcoords[0].size(), 24U);
    for (std::size_t v = 0; v < 24; ++v) {
        const glm::vec3& p = scene.meshes[0].positions[v];
        EXPECT_EQ(texcoords[0][v], glm::vec2(p.x + 10 * p.y, p.z));
    }
}

TEST(FileNormals, ARoundBodyIsSmoothAndANormalOfTheFileStays) {
    scene::Scene scene = bare(catalogue::make_icosphere(1, 2));
    const std::size_t count = scene.meshes[0].positions.size();
    add_normals(scene, 40);
    ASSERT_EQ(scene.meshes[0].normals.size(), count);
    for (std::size_t v = 0; v < count; ++v)
        EXPECT_GT(glm::dot(scene.meshes[0].normals[v], scene.meshes[0].positions[v]), 0.99F);
    scene.meshes[0].normals.assign(count, glm::vec3(1, 0, 0));
    add_normals(scene, 40);
    EXPECT_EQ(scene.meshes[0].normals, std::vector<glm::vec3>(count, glm::vec3(1, 0, 0)));
}

}  // namespace
}  // namespace ink::bake
