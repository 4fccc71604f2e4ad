#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <glm/trigonometric.hpp>
#include <limits>

#include "catalogue/shapes.h"
#include "draw/exr_layers.h"
#include "draw/outline_svg.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "methods/method_configs.h"
#include "score/coverage.h"
#include "tests/core/temp_folder.h"
#include "tests/report/markup.h"
#include "tests/scene/small_meshes.h"

namespace ink::draw {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

/// A cube of side 2 face-on at depth 5, as many px wide as its formula says, in a 64 x 48 frame.
harness::SceneViews cube() {
    harness::ViewRequest request;
    request.width_px = 64;
    request.height_px = 48;
    harness::CameraRequest camera;
    camera.eye_world = {0, 0, 6};
    camera.target_world = glm::dvec3(0);
    camera.fov_deg = glm::degrees(2 * std::atan(24.0 / 60));  // a focal length of 60 px
    request.cameras = {camera};
    return harness::make_scene_views(scene::scene_of(scene::unit_cube()), request);
}

truth::Truth traced(const harness::SceneViews& scene_views) {
    return truth::trace_truth(scene_views.scene, scene_views.views.front(), {});
}

template <class Held>
const Held* channel(const image_io::ExrFile& file, const std::string& name) {
    for (const image_io::ExrChannel& c : file.channels) {
        if (c.name == name) return std::get_if<Held>(&c.pixels);
    }
    return nullptr;
}

std::string text_attribute(const image_io::ExrFile& file, const std::string& name) {
    for (const image_io::ExrAttribute& a : file.attributes) {
        if (a.name == name) return std::get<std::string>(a.value);
    }
    return "(absent)";
}

TEST(TruthExr, HoldsEveryLayerAsItIs) {
    const harness::SceneViews scene_views = cube();
    const truth::Truth truth = traced(scene_views);
    const core::TempFolder folder;
    const fs::path path = folder / "truth_layers.exr";
    write_truth_exr({scene_views}, truth, path);
    const image_io::ExrFile file = image_io::read_exr(path);

    using Ids = core::Image<std::uint32_t>;
    using Floats = core::Image<float>;
    const auto* label = channel<Ids>(file, "class.label");
    const auto* below_crease = channel<Ids>(file, "class.below_crease");
    const auto* triangle = channel<Ids>(file, "id.triangle");
    const auto* patch = channel<Ids>(file, "id.patch");
    const auto* depth = channel<Floats>(file, "Z");
    const auto* facing = channel<Floats>(file, "facing.Y");
    const auto* sampled = channel<image_io::HalfImage>(file, "sampled.Y");
    const auto* corner = channel<image_io::HalfImage>(file, "exact_corner.Y");
    const auto* red = channel<image_io::HalfImage>(file, "R");
    const auto* coverage = channel<Floats>(file, kCoverageChannel);
    ASSERT_TRUE(coverage && label && below_crease && triangle && patch && depth && facing &&
                sampled && corner && red);
    EXPECT_EQ(*triangle, truth.layers.triangle);
    EXPECT_EQ(*patch, truth.layers.patch);
    EXPECT_EQ(*depth, truth.layers.w);
    EXPECT_EQ(*facing, truth.layers.n_dot_v);
    EXPECT_EQ(
        *coverage,
        score::draw_coverage(
            truth.curves, truth.labels.width_px(), truth.labels.height_px(), score::kLineWidth_px));
    std::size_t lines = 0;
    for (std::size_t i = 0; i < label->size(); ++i) {
        EXPECT_EQ(label->data()[i], truth.labels.data()[i]);
        EXPECT_EQ(below_crease->data()[i], truth.below_crease.data()[i]);
        EXPECT_EQ(sampled->pixels.data()[i], truth.sampled.data()[i] / 255.0F);
        EXPECT_EQ(corner->pixels.data()[i], truth.exact_corner.data()[i] / 255.0F);
        lines += label->data()[i] != 0;
    }
    EXPECT_GT(lines, 50U);
    EXPECT_EQ(depth->at(0, 0), std::numeric_limits<float>::infinity());
    EXPECT_EQ(red->pixels.at(0, 0), 1) << "white paper";
    EXPECT_EQ(text_attribute(file, "ink:scene"), "cube");
    EXPECT_THAT(text_attribute(file, "ink:labels"), HasSubstr("3 crease"));
}

TEST(TruthExr, LeavesOutWhatWasNotTraced) {
    const harness::SceneViews scene_views = cube();
    const truth::Truth truth =
        truth::trace_truth(scene_views.scene, scene_views.views.front(), {.layers = false});
    const core::TempFolder folder;
    const fs::path path = folder / "truth_labels.exr";
    write_truth_exr({scene_views}, truth, path);
    const image_io::ExrFile file = image_io::read_exr(path);
    EXPECT_EQ(file.channels.size(), 8U)
        << "R, G, B, class.label, class.below_crease, coverage.Y, crack.right and crack.below";
    using Ids = core::Image<std::uint32_t>;
    const auto* right = channel<Ids>(file, "crack.right");
    ASSERT_NE(right, nullptr);
    // The left side of the square: 60 px / 5 left of the middle, at 20. Centres 19.5 and 20.5.
    EXPECT_EQ(right->at(19, 24), static_cast<std::uint32_t>(truth::LineClass::contour));
    EXPECT_EQ(right->at(20, 24), 0U);
}

TEST(TruthPng, SaysHowItWantsToBeScored) {
    const harness::SceneViews scene_views = cube();
    truth::SceneModel model(scene_views.scene, {});
    const harness::ViewTruth truth = harness::trace_view(model, scene_views.views.front(), {});
    const core::TempFolder folder;
    const fs::path path = folder / "truth_labels.png";
    write_truth_png({scene_views, {}, "inkbench truth cube"}, truth, path);
    const image_io::GrayFile file = image_io::read_gray_file(path);
    EXPECT_EQ(file.pixels, truth.counted_labels());
    EXPECT_EQ(file.texts.at("ink:ignore_label"), "7");
    EXPECT_EQ(file.texts.at("ink:band_px"), "6");
    EXPECT_EQ(file.texts.at("ink:command"), "inkbench truth cube");
    EXPECT_EQ(file.texts.at("ink:scene"), scene_views.scene.name);
    EXPECT_FALSE(file.texts.contains("ink:commit")) << "the same truth is the same file";
}

TEST(DrawingExr, HoldsImageShadingResponseAndLayers) {
    const harness::SceneViews scene_views = cube();
    const method::MethodConfig config = methods::make_configs("mote4", {}).front();
    DrawOptions options;
    options.shading = shade::GouraudParams{};
    const Drawing drawing = make_drawing(scene_views, config, options);
    const edge::EdgeImage& edge_responses = drawing.edge_responses;
    const core::TempFolder folder;
    const fs::path path = folder / "drawing.exr";
    const auto layers = draw_layers(scene_views, config, options);
    write_drawing_exr(scene_views, config, drawing, layers, path);
    const image_io::ExrFile file = image_io::read_exr(path);
    const auto* edge_response = channel<image_io::HalfImage>(file, "response.Y");
    ASSERT_NE(edge_response, nullptr);
    ASSERT_NE(channel<image_io::HalfImage>(file, "G"), nullptr);
    EXPECT_NE(channel<image_io::HalfImage>(file, "shading.G"), nullptr);
    EXPECT_NE(channel<image_io::HalfImage>(file, "packed.R"), nullptr);
    EXPECT_NE(channel<image_io::HalfImage>(file, "filtered.B"), nullptr);
    for (std::size_t i = 0; i < edge_responses.size(); ++i)
        EXPECT_EQ(std::lround(edge_response->pixels.data()[i] * 255), edge_responses.data()[i]);
    EXPECT_EQ(text_attribute(file, "ink:method"), "mote4");
}

TEST(OutlineSvg, IsWellFormedAndSaysWhatEachLineIs) {
    const harness::SceneViews scene_views = cube();
    const std::string svg =
        outline_svg(traced(scene_views), "a \"cube\" & <more>", scene_views.views.front());
    EXPECT_EQ(report::nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(R"(viewBox="0 0 64 48")"));
    EXPECT_THAT(svg, HasSubstr(R"(data-class="contour" data-kind="sky")"));
    EXPECT_THAT(svg, HasSubstr(R"(data-gap="inf inf inf inf")"));
    EXPECT_THAT(svg, HasSubstr(R"(data-dihedral-deg="90 90 90 90")"));
    EXPECT_THAT(svg, Not(HasSubstr("data-class=\"crease\"")));
}

TEST(OutlineSvg, AClassIsOnePath) {
    const std::vector<ClassPath> paths = class_paths(traced(cube()));
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_EQ(paths[0].line_class, "contour");
    // The square of 24 px in the middle of the frame.
    for (const char* corner : {"20,12", "44,12", "44,36", "20,36"})
        EXPECT_THAT(paths[0].path, HasSubstr(corner));
    EXPECT_TRUE(class_paths(truth::Truth()).empty());
}

TEST(OutlineSvg, OfNothingIsAnEmptySheet) {
    truth::Truth nothing;
    scene::View view;
    view.width_px = 8;
    view.height_px = 6;
    const std::string svg = outline_svg(nothing, "nothing", view);
    EXPECT_EQ(report::nesting_error(svg), "");
    EXPECT_THAT(svg, Not(HasSubstr("polyline")));
}

}  // namespace
}  // namespace ink::draw
