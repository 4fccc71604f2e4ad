#include "tests/inspect/id_agreement.h"

#include <gtest/gtest.h>

#include "scene/camera.h"
#include "tests/inspect/compare_ids.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 480;
constexpr int kHeight_px = 270;

void expect_same_ids(const scene::Scene& scene,
                     const scene::View& view,
                     DepthFormat depth,
                     const char* what) {
    const IdAgreement ids = compare_ids(scene, view, depth);
    EXPECT_EQ(ids.in_floats + ids.other, 0U)
        << scene.name << " " << view.camera.name << " " << what;
    EXPECT_GT(ids.covered, 0U) << scene.name << " " << view.camera.name << " " << what;
}

}  // namespace

void expect_same_ids(const scene::Scene& scene, const std::vector<scene::Camera>& cameras) {
    ASSERT_FALSE(cameras.empty()) << scene.name;
    for (const scene::Camera& camera : cameras) {
        const scene::View view{camera, kWidth_px, kHeight_px};
        for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z24})
            expect_same_ids(scene, view, depth, depth == DepthFormat::q32 ? "q32" : "z24");
        expect_same_ids(scene, scene::corner_view(view), DepthFormat::q32, "q32 at corners");
    }
}

std::vector<scene::Camera> round_views(const scene::Scene& scene, int count) {
    return scene::orbit_cameras(
        scene::bounding_sphere(scene), count, static_cast<double>(kWidth_px) / kHeight_px);
}

}  // namespace ink::raster
