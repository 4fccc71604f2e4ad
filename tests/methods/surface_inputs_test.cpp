#include "methods/surface_inputs.h"

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ink::methods {
namespace {

TEST(SurfaceInputs, NormalsAreInViewSpace) {
    // Looking straight down at a floor: its normal points at the eye, along +z of view space.
    const scene::Scene scene = scene_of({floor_mesh(1)});
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    inputs.pose(scene);
    inputs.see({view_from(scene, {0, 5, 0}, {0, 0, 0}, {32, 32}), 1});
    ASSERT_EQ(inputs.n_view().size(), 4U);
    for (const glm::vec3& n : inputs.n_view())
        EXPECT_NEAR(n.z, 1, 1e-6);
    EXPECT_NEAR(inputs.w(0), 5, 1e-12);
}

TEST(SurfaceInputs, ChannelsOfTheBackAreNegatedNormals) {
    const scene::Scene scene = scene_of({cube_mesh()});
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    inputs.see({view_from(scene, {3, 4, 5}, {0, 0, 0}, {32, 32}), 1});
    const DepthCarrier carrier(
        raster::DepthEncoding::inverse, raster::Interpolation::affine, inputs.range());
    std::vector<float> front;
    std::vector<float> back;
    inputs.gather_channels(carrier, 1, front, back);
    ASSERT_EQ(front.size(), 4 * inputs.corner_count());
    for (std::size_t i = 0; i < front.size(); ++i) {
        EXPECT_EQ(back[i], i % 4 == 0 ? front[i] : -front[i]);
    }
}

TEST(SurfaceInputs, CutsWhatCrossesTheNearPlane) {
    // The eye stands a unit above the middle of the floor and looks along it.
    const scene::Scene scene = scene_of({floor_mesh(10)});
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    scene::View view = view_from(scene, {0, 1, 0}, {0, 1, -5}, {32, 32});
    view.camera.near = 0.5;
    inputs.see({view, 1});
    const raster::PassInput input = inputs.pass_input();
    EXPECT_EQ(input.triangles.size(), 3U);  // one keeps a corner in front, the other two
    EXPECT_EQ(input.facing.size(), 3U);
    for (const scene::Triangle& t : input.triangles) {
        for (const std::uint32_t v : t)
            EXPECT_GE(input.p_clip[v].z, 0.5);
    }
}

TEST(SurfaceInputs, PosingTheSameSceneAgainChangesNothing) {
    const scene::Scene scene = cube_on_floor();
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    const scene::View view = view_from(scene, {3, 4, 5}, {0, 0, 0}, {32, 32});
    inputs.see({view, 1});
    const std::size_t corners = inputs.corner_count();
    inputs.pose(scene);
    inputs.see({view, 2});
    EXPECT_EQ(inputs.corner_count(), corners);
}

}  // namespace
}  // namespace ink::methods
