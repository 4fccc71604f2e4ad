#include "buffers/surface_inputs.h"

#include <gtest/gtest.h>

#include "tests/methods/small_scenes.h"

namespace ink::buffers {
namespace {

TEST(SurfaceInputs, DepthAndNormalAreLinearInWhatTheVertexHas) {
    // Looking straight down at a floor: its normal points at the eye, along +z of view space.
    const scene::Scene scene = methods::scene_of({methods::floor_mesh(1)});
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    inputs.pose(scene);
    inputs.see({methods::view_from(scene, {0, 5, 0}, {0, 0, 0}, {32, 32}), 1});
    const LinearChannels channels = inputs.linear_channels();
    const auto component = [&](std::size_t i) {  // of the floor's normal, (0, 1, 0)
        return channels.normal[i].per_normal[1];
    };
    EXPECT_NEAR(component(0), 0, 1e-6);
    EXPECT_NEAR(component(1), 0, 1e-6);
    EXPECT_NEAR(component(2), 1, 1e-6);
    const auto depth = [&](double w) { return channels.depth.base + channels.depth.per_q / w; };
    EXPECT_NEAR(depth(inputs.range().near), 1, 1e-12);
    EXPECT_NEAR(depth(inputs.range().far), 0, 1e-12);
}

TEST(SurfaceInputs, WhatMovedIsKnownByItsObject) {
    scene::Scene scene = methods::cube_on_floor();
    SurfaceInputs inputs({});
    inputs.prepare(scene);
    const scene::View view = methods::view_from(scene, {3, 4, 5}, {0, 0, 0}, {32, 32});
    edge::EdgeImage out(32, 32);
    const method::Frame frame{view, 1};
    inputs.see(frame);
    EXPECT_FALSE(inputs.mesh_input(frame).may_keep_still) << "a scene that never moved";
    inputs.finish({}, out);
    for (int step = 0; step < 2; ++step) {
        scene.instances[0].world_from_object[3][1] += 1e-3;
        inputs.pose(scene);
        inputs.see(frame);
        const raster::MeshInput input = inputs.mesh_input(frame);
        EXPECT_TRUE(input.may_keep_still);
        inputs.finish({}, out);
    }
}

}  // namespace
}  // namespace ink::buffers
