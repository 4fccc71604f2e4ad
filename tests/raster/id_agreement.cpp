#include "tests/raster/id_agreement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "draw/id_agreement.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 480;
constexpr int kHeight_px = 270;

}  // namespace

void expect_same_ids(const scene::Scene& scene, const std::vector<scene::Camera>& cameras) {
    ASSERT_FALSE(cameras.empty()) << scene.name;
    for (const scene::Camera& camera : cameras) {
        for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z24}) {
            const draw::IdAgreement ids =
                draw::compare_ids(scene, {camera, kWidth_px, kHeight_px}, depth);
            fmt::print(
                "{:<16} {:<10} {} {:7} covered, differ: {:4} near an edge, {:4} in depth, {} "
                "else\n",
                scene.name,
                camera.name,
                depth == DepthFormat::q32 ? "q32" : "z24",
                ids.covered,
                ids.near_edge,
                ids.near_depth,
                ids.other);
            EXPECT_EQ(ids.other, 0U) << scene.name << " " << camera.name;
            EXPECT_GT(ids.covered, 0U) << scene.name << " " << camera.name;
        }
    }
}

std::vector<scene::Camera> round_views(const scene::Scene& scene, int count) {
    return scene::orbit_cameras(
        scene::bounding_sphere(scene), count, static_cast<double>(kWidth_px) / kHeight_px);
}

}  // namespace ink::raster
