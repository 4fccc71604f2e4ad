#include "harness/scores/miss_prediction.h"
#include "harness/truths/tracing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/named.h"
#include "harness/cells/cell.h"
#include "harness/suite/suite.h"
#include "harness/truths/truth_code.h"
#include "methods/registry.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {
namespace {

using score::Cause;
using score::Pixel;
using truth::LineClass;

constexpr int kWidth_px = 160;
constexpr int kHeight_px = 120;

/// A camera on the z axis `distance` from the origin, looking down at it.
scene::View view_from(double distance, double fov_deg, const scene::Scene& scene) {
    scene::Camera camera =
        scene::look_at({0, 0, distance}, {0, 0, 0}, {0, 1, 0}, fov_deg * std::numbers::pi / 180);
    scene::fit_clip_range(camera, scene::bounding_sphere(scene));
    return {camera, kWidth_px, kHeight_px};
}

/// A roof of two faces at right angles whose ridge runs through the origin along (2, 2, -1).
///
/// Their normals are (-1, 2, 2)/3 and (2, -1, 2)/3: x and y change by 1 across the ridge, their sum
/// does not. The view is so narrow that 1/w hardly bends there.
scene::Scene roof() {
    const glm::vec3 along = glm::vec3(2, 2, -1) / 3.0F;
    const glm::vec3 n0 = glm::vec3(-1, 2, 2) / 3.0F;
    const glm::vec3 n1 = glm::vec3(2, -1, 2) / 3.0F;
    scene::Mesh mesh;
    mesh.name = "roof";
    mesh.positions = {-along, along, along - n1, -along - n1, along - n0, -along - n0};
    // Counter-clockwise seen from n0 and n1: the first face falls off along -n1, the other along
    // -n0.
    const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c, glm::vec3 normal) {
        const auto& p = mesh.positions;
        const bool is_turned = glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), normal) < 0;
        mesh.triangles.push_back(is_turned ? scene::Triangle{a, c, b} : scene::Triangle{a, b, c});
    };
    add(0, 1, 2, n0);
    add(0, 2, 3, n0);
    add(0, 1, 4, n1);
    add(0, 4, 5, n1);
    return scene::scene_of(mesh);
}

/// What a method got wrong on a view, and why.
struct Explained {
    ViewTruth truth;
    Scored scored;
};

Explained explain(const scene::Scene& scene,
                  const scene::View& view,
                  const std::string& method,
                  const core::ParamValues& settings) {
    const method::MethodConfig config{&methods::find_method(method), settings};
    const PreparedMethods methods = prepare_methods(std::span(&config, 1), scene);
    std::vector<edge::EdgeImage> images;
    (void)draw_in_turns(methods, view, {1, 0, 0, 0}, images);
    truth::SceneModel model(scene, {});
    Explained result{trace_view(model, view, {}), {}};
    const int threshold = methods[0]->threshold();
    result.scored = score_image(images[0], list_tolerances(result.truth.scoring), threshold);
    MissPredictor predictor(scene);
    result.scored.attribution = predictor.attribute(
        result.scored.wrong_2px, result.truth, view, {methods[0]->method().code(), threshold});
    return result;
}

/// How many missing pixels of a class have a cause, and how many another one.
struct Tally {
    int of_cause = 0;
    int of_others = 0;
};

Tally tally(const Explained& explained, LineClass line_class, Cause cause) {
    Tally tally;
    for (const auto& [pixel, why] : explained.scored.attribution.pixels) {
        const auto label = explained.truth.scoring.labels.at(pixel.x_px, pixel.y_px);
        if (!score::is_miss(why) || label != static_cast<int>(line_class)) continue;
        ++(why == cause ? tally.of_cause : tally.of_others);
    }
    return tally;
}

TEST(MissPrediction, ARidgeWhoseChannelsCancelIsCancelled) {
    const scene::Scene scene = roof();
    const scene::View view = view_from(20, 8, scene);
    const Explained explained = explain(scene, view, "mote4", {{"sky", "255"}});
    const Tally ridge = tally(explained, LineClass::crease, Cause::cancelled);
    // The ridge is 2 * 2/3 units long both ways, at 120 px / (40 tan(4 deg)) px a unit: 57 px.
    EXPECT_GE(ridge.of_cause, 45);
    EXPECT_LE(ridge.of_others, 4) << "at its ends the outline's stencils see it too";
}

TEST(MissPrediction, TheSameRidgeIsFoundByACodeThatTellsXFromY) {
    const scene::Scene scene = roof();
    const scene::View view = view_from(20, 8, scene);
    const Explained explained = explain(scene, view, "mote4", {{"sky", "255"}, {"range_ny", "0"}});
    const Tally ridge = tally(explained, LineClass::crease, Cause::cancelled);
    EXPECT_EQ(ridge.of_cause + ridge.of_others, 0);
}

TEST(MissPrediction, ARidgeThatNoChannelShowsIsBelowTheThreshold) {
    const scene::Scene scene = roof();
    const scene::View view = view_from(20, 8, scene);
    // A step of 63/2 in x, and a cross sees it from three of its four ends at most: 94.5 < 100.
    const Explained explained =
        explain(scene, view, "mote4", {{"sky", "255"}, {"threshold", "100"}});
    const Tally ridge = tally(explained, LineClass::crease, Cause::below_threshold);
    EXPECT_GE(ridge.of_cause, 45);
    EXPECT_EQ(ridge.of_others, 0);
}

TEST(MissPrediction, ASliverBetweenPixelCentresIsSubPixel) {
    scene::Scene scene = scene::scene_of(scene::unit_cube());
    scene::View view = view_from(10, 20, scene);
    // Upright at w = 10, from 40.6 to 40.9 px: between the centres at 40.5 and 41.5.
    const double px_per_unit = (kHeight_px / 2.0) / std::tan(10 * std::numbers::pi / 180) / 10;
    const auto left = static_cast<float>((40.6 - kWidth_px / 2.0) / px_per_unit);
    const auto right = static_cast<float>((40.9 - kWidth_px / 2.0) / px_per_unit);
    scene::Mesh sliver;
    sliver.name = "sliver";
    sliver.positions = {{left, -1, 0}, {right, -1, 0}, {right, 1, 0}, {left, 1, 0}};
    sliver.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene = scene::scene_of(sliver);
    const Explained explained = explain(scene, view, "mote4", {});
    EXPECT_GT(explained.scored.at_2px.false_negatives, 60) << "two units are 68 px";
    EXPECT_EQ(explained.scored.attribution.counts[Cause::sub_pixel],
              explained.scored.at_2px.false_negatives);
}

TEST(MissPrediction, ALineThatTheCodeShowsIsUnexplainedIfItIsSaidToBeMissing) {
    const scene::Scene scene = scene::scene_of(scene::unit_cube());
    const scene::View view = view_from(10, 20, scene);
    truth::SceneModel model(scene, {});
    const ViewTruth truth = trace_view(model, view, {});
    std::vector<Pixel> contour;
    for (int y = 0; y < kHeight_px; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            if (truth.scoring.labels.at(x, y) == 1) contour.push_back({x, y});
        }
    }
    ASSERT_GT(contour.size(), 100U);
    method::LinearCode code;
    code.normal_weight[2] = 200;  // the front sees 200, the sky 0
    MissPredictor predictor(scene);
    for (const Cause cause : predictor.predict(contour, truth, view, {code, 100}))
        EXPECT_EQ(cause, Cause::unexplained);
    code.normal_weight[2] = 20;
    for (const Cause cause : predictor.predict(contour, truth, view, {code, 100}))
        EXPECT_EQ(cause, Cause::below_threshold);
    EXPECT_TRUE(predictor.predict(contour, truth, view, {std::nullopt, 100}).empty());
    EXPECT_TRUE(predictor.predict({}, truth, view, {code, 100}).empty());
}

/// A square of two triangles at w = `w` straight ahead, its front or its back to the eye.
scene::Scene square(double z, bool is_turned) {
    scene::Mesh mesh;
    mesh.name = "square";
    const auto depth = static_cast<float>(z);
    mesh.positions = {{-1, -1, depth}, {1, -1, depth}, {1, 1, depth}, {-1, 1, depth}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    if (is_turned) mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
    return scene::scene_of(mesh);
}

PixelCode middle_code(const scene::Scene& scene,
                      const scene::View& view,
                      const method::LinearCode& code) {
    const scene::Surface surface = scene::flatten(scene, scene::NormalSource::facet, 1);
    return TruthCode(surface, scene::bounding_sphere(scene), view, code)
        .at(kWidth_px / 2, kHeight_px / 2, 0);
}

TEST(TruthCode, IsTheWeightedSumOfDepthAndNormal) {
    const scene::Scene scene = square(0, false);
    scene::View view = view_from(10, 20, scene);
    view.camera.near = 5;
    view.camera.far = 20;
    method::LinearCode code;
    code.inputs.depth_range = method::RangeSource::camera;
    code.depth_weight = 90;
    code.normal_weight[0] = 20;
    code.normal_weight[1] = 30;
    code.normal_weight[2] = 40;
    // 1/w: (1/10 - 1/20) / (1/5 - 1/20) = 1/3. The normal is (0, 0, 1): halves, and all of z.
    PixelCode pixel = middle_code(scene, view, code);
    EXPECT_NEAR(pixel.channels[0], 30, 1e-5);
    EXPECT_NEAR(pixel.channels[1], 10, 1e-5);
    EXPECT_NEAR(pixel.channels[2], 15, 1e-5);
    EXPECT_NEAR(pixel.channels[3], 40, 1e-5);
    EXPECT_EQ(pixel.code, 95);
    code.encoding = raster::DepthEncoding::linear;  // (20 - 10) / (20 - 5) = 2/3
    EXPECT_NEAR(middle_code(scene, view, code).channels[0], 60, 1e-5);
    code.offset = 90;  // far = high
    code.depth_weight = -90;
    EXPECT_NEAR(middle_code(scene, view, code).channels[0], -60, 1e-5);
    EXPECT_EQ(middle_code(scene, view, code).code, 95);
}

// A view from inside is among them, whose triangles the near plane cuts.
TEST(TruthCode, IsWhatMethodsDrawUnderBothProjections) {
    for (const char* name : {"gear", "torus", "room", "fence"}) {
        ViewRequest request;
        request.width_px = 320;
        request.height_px = 180;
        using enum scene::ProjectionKind;
        request.projections = {perspective, parallel};
        const SceneViews of = make_scene_views(load_scene(name), request);
        const auto method = methods::find_method("mote4").make({});
        method->prepare(of.scene);
        method->pose(of.scene);
        const method::LinearCode code = method->code().value();
        const scene::Surface surface =
            scene::flatten(of.scene, code.inputs.normals, code.inputs.crease_rad);
        for (const scene::View& view : of.views) {
            const core::Image<std::uint32_t> triangle =
                truth::trace_truth(of.scene, view, {}).layers.triangle;
            const TruthCode truth_code(surface, scene::bounding_sphere(of.scene), view, code);
            const auto layers = method->layers({view, 1});
            const method::Layer* packed = core::find_named(layers, "packed");
            ASSERT_NE(packed, nullptr);
            std::size_t seen = 0, off = 0;
            for (int y = 0; y < view.height_px; ++y) {
                for (int x = 0; x < view.width_px; ++x) {
                    if (triangle.at(x, y) == truth::kNoTriangle) continue;
                    const int expected = truth_code.at(x, y, triangle.at(x, y)).code;
                    ++seen;
                    off += std::abs(packed->codes[0].at(x, y) - expected) > 1 ? 1 : 0;
                }
            }
            EXPECT_LE(off, seen / 100) << name << " " << view.camera.name << " " << seen;
        }
    }
}

TEST(TruthCode, ABackShowsTheNegatedNormal) {
    const scene::Scene scene = square(0, true);
    method::LinearCode code;
    code.normal_weight[2] = 40;
    EXPECT_EQ(middle_code(scene, view_from(10, 20, scene), code).code, 40);
}

TEST(TruthCode, SaturatesOrWraps) {
    const scene::Scene scene = square(0, false);
    const scene::View view = view_from(10, 20, scene);
    method::LinearCode code;
    code.normal_weight[2] = 300;
    EXPECT_EQ(middle_code(scene, view, code).code, 255);
    code.wraps = true;
    EXPECT_EQ(middle_code(scene, view, code).code, 44);
    code.normal_weight[2] = -3;
    EXPECT_EQ(middle_code(scene, view, code).code, 253);
    code.wraps = false;
    EXPECT_EQ(middle_code(scene, view, code).code, 0);
}

TEST(TruthCode, SkyHoldsItsCodeAndNoChannel) {
    const scene::Scene scene = square(0, false);
    const scene::View view = view_from(10, 20, scene);
    const scene::Surface surface = scene::flatten(scene, scene::NormalSource::facet, 1);
    method::LinearCode code;
    code.sky_code = 7;
    code.normal_weight[0] = 99;
    const TruthCode truth_code(surface, scene::bounding_sphere(scene), view, code);
    const PixelCode pixel = truth_code.at(3, 3, truth::kNoTriangle);
    EXPECT_EQ(pixel.code, 7);
    EXPECT_EQ(pixel.channels, (std::array<double, 4>{}));
}

}  // namespace
}  // namespace ink::harness
