// Scenes of the catalogue whose outlines are known without tracing them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/catalogue.h"
#include "scene/camera.h"
#include "scene/topology.h"
#include "tests/truth/shapes.h"
#include "truth/truth.h"

namespace ink::truth {
namespace {

struct Traced {
    scene::Scene scene;
    scene::View view;
    Truth truth;
};

Traced trace_view_of(const char* name, const char* view_name) {
    Traced traced{catalogue::make_catalogue_scene(name), {}, {}};
    const auto camera = std::find_if(traced.scene.cameras.begin(),
                                     traced.scene.cameras.end(),
                                     [&](const auto& c) { return c.name == view_name; });
    traced.view = {*camera, 1280, 720};
    const TruthOptions options{.threads = 2, .layers = false};
    traced.truth = trace_truth(traced.scene, traced.view, options);
    return traced;
}

TEST(CatalogueForms, AMillionTrianglesShowOneCircle) {
    const Traced globe = trace_view_of("globe", "front");
    // The ball of radius 1 about the origin: its outline's radius is f / sqrt(d^2 - 1).
    const double focal_px = 360 / std::tan(globe.view.camera.fov_y_rad / 2);
    const double distance = glm::length(globe.view.camera.eye_world);
    const double radius_px = focal_px / std::sqrt(distance * distance - 1);
    double length = 0;
    for (const Curve& curve : globe.truth.curves) {
        ASSERT_EQ(curve.line_class, LineClass::contour);
        length += length_px(curve);
        for (const CurvePoint& p : {curve.begin, curve.end})
            EXPECT_NEAR(std::hypot(p.x_px - 640, p.y_px - 360), radius_px, 0.02);
    }
    // Edges of the mesh go round it in steps of a pixel that need not be straight on.
    EXPECT_GE(length, 2 * std::numbers::pi * radius_px * 0.999);
    EXPECT_LE(length, 2 * std::numbers::pi * radius_px * std::numbers::sqrt2);
}

TEST(CatalogueForms, BarsAreAsWideAsTheySay) {
    const Traced bars = trace_view_of("bars", "front");
    const scene::Projection projection(bars.view);
    int number = 0;
    for (const scene::Instance& instance : bars.scene.instances) {
        if (instance.name != "upright") continue;
        double low = 1e9;
        double high = -1e9;
        for (const auto& p : bars.scene.meshes[instance.mesh].positions) {
            if (p.z != 0) continue;  // its front
            const glm::dvec3 clip = projection.to_clip(scene::to_world(instance, p));
            low = std::min(low, clip.x / clip.z);
            high = std::max(high, clip.x / clip.z);
        }
        EXPECT_NEAR(high - low, 0.05 + 0.01 * number, 1e-3) << number;
        ++number;
    }
    EXPECT_EQ(number, 16);
}

TEST(CatalogueForms, EveryBarShowsBothItsSides) {
    const Traced bars = trace_view_of("bars", "front");
    // 16 uprights of 4 units and 16 levels of 3, two long sides each, 64 px a unit. Nothing hides
    // them; their ends are a fraction of a pixel.
    double contours = 0;
    for (const Curve& curve : bars.truth.curves) {
        if (curve.line_class == LineClass::contour) contours += length_px(curve);
    }
    const double sides_px = 64 * 2 * 16 * (4.0 + 3);
    EXPECT_NEAR(contours, sides_px, 0.001 * sides_px);
}

TEST(CatalogueForms, SmoothBodiesHideThemselves) {
    for (const char* name : {"octopus", "hand", "drapery"}) {
        const Traced traced = trace_view_of(name, "front");
        double self = 0;
        double all = 0;
        for (const Curve& curve : traced.truth.curves) {
            if (curve.line_class != LineClass::contour) continue;
            all += length_px(curve);
            if (curve.kind == ContourKind::self) self += length_px(curve);
        }
        EXPECT_GT(self, 0.15 * all) << name;
    }
}

}  // namespace
}  // namespace ink::truth
