#include "raster/lines/line_vertices.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/simd.h"

namespace ink::raster {
namespace {

/// Points in all directions from the eye, near and far, some of no use at all; not a whole vector.
std::vector<glm::dvec3> points() {
    std::vector<glm::dvec3> result;
    for (int i = -9; i <= 9; ++i) {
        for (int k = -9; k <= 9; ++k)
            result.push_back({0.31 * i + 0.01 * k, 0.17 * k, -0.4 * (i + k) - 3.1});
    }
    for (int k = 0; k < 40; ++k)  // all of them in the image
        result.push_back({0.02 * k - 0.4, 0.3 - 0.013 * k, -3 - 0.1 * k});
    result.push_back({1e200, 0, -3});
    result.push_back({std::numeric_limits<double>::quiet_NaN(), 0, -3});
    result.push_back({1e9, 1, -3});
    return result;
}

TEST(LineVertices, AreThoseOfOneVertexAfterTheOther) {
    scene::View view;
    view.camera.near = 0.5;
    view.width_px = 640;
    view.height_px = 480;
    const ViewTransform transform(view);
    const std::vector<glm::dvec3> p_world = points();
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        std::vector<glm::dvec3> p_clip(p_world.size());
        std::vector<ScreenVertex> screen(p_world.size());
        std::vector<std::uint8_t> outcodes(p_world.size());
        project_vertices(transform,
                         view.camera.near,
                         p_world.data(),
                         p_world.size(),
                         {p_clip.data(), screen.data(), outcodes.data()});
        int inside = 0;
        for (std::size_t i = 0; i < p_world.size(); ++i) {
            const glm::dvec3 expected = transform.to_clip(p_world[i]);
            ASSERT_EQ(outcodes[i], outcode(expected, view.camera.near)) << target.name << ' ' << i;
            if (outcodes[i] == kNotANumber) continue;
            EXPECT_EQ(p_clip[i], expected) << target.name << ' ' << i;
            if (outcodes[i] != kInside) continue;
            ++inside;
            const ScreenVertex vertex = to_screen(expected);
            EXPECT_EQ(screen[i].x_px, vertex.x_px);
            EXPECT_EQ(screen[i].y_px, vertex.y_px);
            EXPECT_EQ(screen[i].q, vertex.q);
            EXPECT_EQ(screen[i].x, vertex.x);
            EXPECT_EQ(screen[i].y, vertex.y);
        }
        EXPECT_GT(inside, 100);
    }
}

}  // namespace
}  // namespace ink::raster
