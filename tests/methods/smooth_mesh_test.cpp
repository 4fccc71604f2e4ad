// Which faces a smooth patch holds, on meshes that can be counted by hand.

#include "methods/surface_codes/smooth_mesh.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/vec3.hpp>
#include <vector>

#include "methods/surface_codes/surface_codes.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {
namespace {

using scene::add_quad;
using scene::scene_of;

constexpr buffers::PatchOptions kOptions{.crease_rad = 0.7, .weld_epsilon = 1e-4};

std::uint32_t patches(const scene::Scene& scene) {
    return make_smooth_mesh(scene, kOptions)->patch_count;
}

/// Two flat squares side by side, and a third that leaves their common edge at a slope.
scene::Mesh three_sheets(float rise) {
    scene::Mesh mesh;
    add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {-1, 0, 0});
    add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {0.5F, rise, 0});
    return mesh;
}

TEST(SmoothMesh, AWallGoesOnBehindAnotherThatMeetsIt) {
    const SmoothMesh mesh = *make_smooth_mesh(scene_of({three_sheets(3)}), kOptions);
    EXPECT_EQ(mesh.patch_count, 2U);
    EXPECT_EQ(mesh.patch_of[0], mesh.patch_of[2]);
    EXPECT_EQ(mesh.borders.size(), 2U);  // of the wall with either side
}

TEST(SmoothMesh, WhereThreeSheetsPartNoneGoesOn) {
    EXPECT_EQ(patches(scene_of({three_sheets(0.1F)})), 3U);
}

/// A square, and two of half its height beside it, `gap` apart and sloping by `rise`.
scene::Mesh t_junction(float gap, float rise) {
    scene::Mesh mesh;
    add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {-1, 0, 0});
    add_quad(mesh, {gap, 0, 0}, {0, 0.5F, 0}, {1, 0, rise});
    add_quad(mesh, {gap, 0.5F, 0}, {0, 0.5F, 0}, {1, 0, rise});
    return mesh;
}

TEST(SmoothMesh, ASurfaceGoesOnOverATJunction) {
    const SmoothMesh mesh = *make_smooth_mesh(scene_of({t_junction(0, 0.3F)}), kOptions);
    EXPECT_EQ(mesh.patch_count, 1U);
    EXPECT_EQ(mesh.touching.size(), 2U);
    EXPECT_TRUE(mesh.borders.empty());
    EXPECT_EQ(patches(scene_of({t_junction(1e-5F, 0)})), 1U);
}

TEST(SmoothMesh, ATJunctionPartsWhatCreasesOrGapesAndObjects) {
    EXPECT_EQ(patches(scene_of({t_junction(0, 2)})), 2U);
    EXPECT_EQ(patches(scene_of({t_junction(0.01F, 0)})), 2U);
    scene::Mesh left, right;
    add_quad(left, {0, 0, 0}, {0, 1, 0}, {-1, 0, 0});
    add_quad(right, {0, 0, 0}, {0, 0.5F, 0}, {1, 0, 0});
    EXPECT_EQ(patches(scene_of({left, right})), 2U);
}

TEST(SmoothMesh, SheetsThatLieOnEachOtherAreNotJoined) {
    scene::Mesh mesh;
    add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {1, 0, 0});
    add_quad(mesh, {0, 0.25F, 0}, {0, 0.5F, 0}, {1, 0, 0});
    EXPECT_EQ(patches(scene_of({mesh})), 2U);
}

TEST(SmoothMesh, CodesGoOnOverATJunction) {
    const scene::Scene scene = scene_of({t_junction(0, 0.3F)});
    CodeOptions options;
    options.patches = kOptions;
    options.turn_rad = 0.02;
    SurfaceCodes made(options);
    made.prepare(scene);
    const auto codes = made.codes({});
    const SmoothMesh& mesh = made.mesh();
    for (const FacePair& pair : mesh.touching) {
        const int a = static_cast<int>(codes[mesh.topology.faces[pair.face0].triangle]);
        const int b = static_cast<int>(codes[mesh.topology.faces[pair.face1].triangle]);
        EXPECT_LE(std::abs(a - b), 1);
    }
}

TEST(SmoothMesh, TrianglesThatWeldingLeftNoAreaFollowThoseRoundThem) {
    // A square of squares, those in the middle far below the weld's distance: none but the outer
    // ones touch what is left.
    scene::Mesh mesh;
    const std::vector<float> at{0, 0.5F - 3e-6F, 0.5F - 1e-6F, 0.5F + 1e-6F, 0.5F + 3e-6F, 1};
    const auto n = static_cast<std::uint32_t>(at.size());
    for (const float y : at)
        for (const float x : at)
            mesh.positions.push_back({x, y, 0});
    for (std::uint32_t y = 0; y + 1 < n; ++y) {
        for (std::uint32_t x = 0; x + 1 < n; ++x) {
            const std::uint32_t a = y * n + x;
            mesh.triangles.push_back({a, a + 1, a + n});
            mesh.triangles.push_back({a + 1, a + n + 1, a + n});
        }
    }
    const scene::Scene scene = scene_of({mesh});
    const SmoothMesh smooth = *make_smooth_mesh(scene, kOptions);
    EXPECT_LT(smooth.face_count(), mesh.triangles.size());
    for (const std::uint32_t face : *faces_of_triangles(scene, smooth, kOptions.weld_epsilon))
        EXPECT_NE(face, SmoothMesh::kNone);
}

}  // namespace
}  // namespace ink::methods
