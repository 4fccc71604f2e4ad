#include "raster/pass/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "raster/pass/screen_vertex.h"
#include "scene/camera.h"
#include "tests/raster/gather_sink.h"
#include "tests/scene/small_meshes.h"

namespace ink::raster {
namespace {

ClipVertex vertex(double x, double y, double w, double value = 0) {
    return {{x, y, w}, {value, 0, 0, 0}};
}

TEST(Clip, LeavesATriangleInsideAlone) {
    const ClipPolygon polygon =
        clip_triangle({vertex(0, 0, 1), vertex(5, 0, 2), vertex(0, 5, 3)}, 0.5);
    ASSERT_EQ(polygon.count, 3);
    EXPECT_EQ(polygon.corners[1].p_clip, glm::dvec3(5, 0, 2));
}

TEST(Clip, CutsAtNearExactlyAndValuesRunLinearlyInClipSpace) {
    // From w = 3 to w = -1 the near plane w = 1 lies half way.
    const ClipPolygon polygon =
        clip_triangle({vertex(0, 0, 3, 10), vertex(8, 0, -1, 20), vertex(0, 8, 3, 10)}, 1);
    ASSERT_EQ(polygon.count, 4);
    EXPECT_EQ(polygon.corners[1].p_clip, glm::dvec3(4, 0, 1));
    EXPECT_EQ(polygon.corners[1].values[0], 15);
    EXPECT_EQ(polygon.corners[2].p_clip, glm::dvec3(4, 4, 1));
}

TEST(Clip, NothingIsLeftOfATriangleBeforeNear) {
    EXPECT_EQ(clip_triangle({vertex(0, 0, 0.4), vertex(5, 0, -2), vertex(0, 5, 0.1)}, 0.5).count,
              0);
}

TEST(Clip, NeighboursCutTheirEdgeAtTheSameBits) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1e7, 1e7);
    std::uniform_real_distribution<double> depth(-2, 3);
    int cut_edges = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto any = [&] { return vertex(anywhere(random), anywhere(random), depth(random)); };
        const ClipVertex a = any();
        const ClipVertex b = any();
        const ClipPolygon left = clip_triangle({a, b, any()}, 0.01);
        const ClipPolygon right = clip_triangle({any(), b, a}, 0.01);
        // New corners on the edge are those that both have and that are neither a nor b.
        for (int l = 0; l < left.count; ++l) {
            const glm::dvec3& p = left.corners[static_cast<std::size_t>(l)].p_clip;
            const glm::dvec3 along = glm::normalize(b.p_clip - a.p_clip);
            const glm::dvec3 from_a = p - a.p_clip;
            const double off = glm::length(from_a - along * glm::dot(along, from_a));
            if (off > 1e-4 || p == a.p_clip || p == b.p_clip) continue;
            bool is_shared = false;
            for (int r = 0; r < right.count; ++r)
                is_shared = is_shared || right.corners[static_cast<std::size_t>(r)].p_clip == p;
            EXPECT_TRUE(is_shared) << i;
            ++cut_edges;
        }
    }
    EXPECT_GT(cut_edges, 300);
}

/// A box round the origin of half size `half`, twelve triangles.
TestMesh box_seen_from(const scene::Camera& camera, const glm::dvec3& half, int size_px) {
    const scene::Projection projection({camera, size_px, size_px});
    TestMesh mesh;
    const scene::Mesh cube = scene::unit_cube();
    for (const glm::vec3& p : cube.positions)
        mesh.p_clip.push_back(projection.to_clip(glm::dvec3(p) * half));
    for (const auto& [a, b, c] : cube.triangles)
        mesh.triangles.push_back({a, c, b});  // fronts inside
    return mesh;
}

TEST(Clip, ACameraInsideABoxSeesEveryPixelOnce) {
    constexpr int kSize_px = 40;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    const core::Image<int> once(kSize_px, kSize_px, 1);
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 eye(unit(random) * 0.9, unit(random) * 0.9, unit(random) * 0.9);
        const glm::dvec3 view_direction(unit(random), unit(random), unit(random) + 0.01);
        scene::Camera camera = scene::look_at(eye, eye + view_direction, {0, 1, 0}, 1.5);
        const TestMesh mesh = box_seen_from(camera, {1, 1, 1}, kSize_px);
        PassInput input = mesh.input();
        input.near = 0.01;
        const auto count = count_coverage(input, kSize_px, kSize_px);
        EXPECT_EQ(count, once) << "pose " << i;
    }
}

TEST(Clip, ABoxAMillionTimesLargerThanTheImageStaysClosed) {
    // Its corners project far beyond the guard band.
    constexpr int kSize_px = 40;
    scene::Camera camera = scene::look_at({0, 0, 0}, {0.3, -0.2, -1}, {0, 1, 0}, 0.7);
    TestMesh mesh = box_seen_from(camera, {1e9, 0.001, 1e9}, kSize_px);
    PassInput input = mesh.input();
    input.near = 1e-5;
    EXPECT_EQ(count_coverage(input, kSize_px, kSize_px), core::Image<int>(kSize_px, kSize_px, 1));
}

TEST(Clip, WhatIsNotANumberIsNotDrawn) {
    TestMesh mesh;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    mesh.add_triangle({1, 1, 1}, {30, 1, 1}, {nan, 30, 1});
    mesh.add_triangle({1, 1, 1}, {30, 1, infinity}, {1, 30, 1});
    mesh.add_triangle({1, 1, 1}, {30, 1, nan}, {1, 30, 1});
    mesh.add_triangle({1, 1, 1}, {1e300, 1, 1}, {1, 30, 1});
    mesh.add_triangle({1, 1, 1}, {1e100, 1, 1}, {1, 30, 1});
    const auto drawn = draw_ids(mesh.input(), 32, 32);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const std::uint32_t id = drawn.planes[0].at(x, y);
            EXPECT_TRUE(id == kNobody || id == 4) << id;
            EXPECT_TRUE(std::isfinite(drawn.depth.at(x, y)));
        }
    }
    EXPECT_EQ(drawn.planes[0].at(31, 1), 4U) << "huge but finite is drawn";
}

/// Of the w of the near end nothing is left in the difference of both.
TEST(Clip, AnEdgeLongerThanANumberHasDigitsStaysBeforeNear) {
    const double near = 0.5;
    for (const double x_px : {2e9, -2e9}) {
        const std::array<ClipVertex, 3> triangle = {
            vertex(0, 0, 1e20), vertex(x_px, 0, near), vertex(0, x_px, near)};
        const ClipPolygon polygon = clip_triangle(triangle, near);
        for (int i = 0; i < polygon.count; ++i) {
            const glm::dvec3& p = polygon.corners[static_cast<std::size_t>(i)].p_clip;
            EXPECT_GE(p.z, near);
            EXPECT_LE(std::abs(to_screen(p).x), (kGuardBand_px + 1) * kSubpixels);
            EXPECT_LE(std::abs(to_screen(p).y), (kGuardBand_px + 1) * kSubpixels);
        }
        EXPECT_GE(polygon.count, 3);
    }
}

TEST(Clip, NothingBehindTheEyeIsSeen) {
    TestMesh mesh;
    mesh.add_triangle({-50, -50, -3}, {90, -50, -3}, {-50, 90, -3});
    EXPECT_EQ(count_coverage(mesh.input(), 16, 16), core::Image<int>(16, 16, 0));
}

}  // namespace
}  // namespace ink::raster
