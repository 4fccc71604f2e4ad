#include "draw/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "draw/palette.h"
#include "harness/images/outline_image.h"
#include "methods/method_configs.h"
#include "tests/core/temp_folder.h"

namespace ink::draw {
namespace {

/// The catalogue's cube, seen small: enough for lines.
harness::SceneViews small_scene_views(int width_px = 96, int height_px = 54) {
    harness::ViewRequest request;
    request.width_px = width_px;
    request.height_px = height_px;
    return harness::load_one_view("cube", "", request);
}

method::MethodConfig mote4() {
    return methods::make_configs("mote4", {}).front();
}

std::ptrdiff_t count_of(const RgbImage& image, const glm::u8vec3& color) {
    return std::count(image.data(), image.data() + image.size(), color);
}

std::ptrdiff_t ink_of(const edge::EdgeImage& edge_responses) {
    return std::count_if(edge_responses.data(),
                         edge_responses.data() + edge_responses.size(),
                         [](int s) { return s > 0; });
}

TEST(MakeDrawing, PlainIsInkOnPaperWhereResponsesAreFull) {
    const Drawing drawing = make_drawing(small_scene_views(), mote4(), {});
    const auto ink = count_of(drawing.image, kInk.rgb);
    EXPECT_GT(ink, 0);
    EXPECT_EQ(ink + count_of(drawing.image, kPaper.rgb), 96 * 54);
    EXPECT_TRUE(drawing.shading.is_empty());
}

TEST(MakeDrawing, IsReadAsTheSharesThatItsInkHas) {
    const core::TempFolder folder;
    const Drawing drawing =
        make_drawing(small_scene_views(), methods::make_configs("strokes", {}).front(), {});
    write_drawing(drawing.image, folder / "drawn.png");
    const edge::EdgeImage read = harness::read_outline_image(folder / "drawn.png").responses;
    ASSERT_EQ(read.size(), drawing.edge_responses.size());
    for (std::size_t i = 0; i < read.size(); ++i)  // ink is not quite black
        ASSERT_NEAR(read.data()[i], drawing.edge_responses.data()[i], 6) << i;
}

TEST(MakeDrawing, KeepsTheSizeOfTheViewWhenAntialiased) {
    const Drawing drawing = make_drawing(small_scene_views(), mote4(), {.antialias = 3});
    EXPECT_EQ(drawing.image.width_px(), 96);
    EXPECT_EQ(drawing.edge_responses.height_px(), 54);
    const auto plain = count_of(drawing.image, kInk.rgb) + count_of(drawing.image, kPaper.rgb);
    EXPECT_LT(plain, 96 * 54) << "no shades between ink and paper";
}

TEST(MakeDrawing, InkKeepsItsGreyAndHasAnyWidth) {
    const harness::SceneViews scene_views = small_scene_views();
    const method::MethodConfig strokes = methods::make_configs("strokes", {}).front();
    const Drawing one = make_drawing(scene_views, strokes, {});
    EXPECT_LT(count_of(one.image, kInk.rgb) + count_of(one.image, kPaper.rgb), 96 * 54);
    const auto sum = [](const edge::EdgeImage& image) {
        return std::accumulate(image.data(), image.data() + image.size(), 0.0);
    };
    const Drawing three = make_drawing(scene_views, strokes, {.line_width_px = 3});
    EXPECT_GT(sum(three.edge_responses), 2 * sum(one.edge_responses));
    // It has its samples: more of them are for the shading alone.
    EXPECT_EQ(make_drawing(scene_views, strokes, {.antialias = 2}).image, one.image);
}

TEST(MakeDrawing, AWidthOfOneIsThinnedAndWiderHasMoreInk) {
    const harness::SceneViews scene_views = small_scene_views();
    const auto as_drawn = ink_of(make_drawing(scene_views, mote4(), {}).edge_responses);
    const auto one =
        ink_of(make_drawing(scene_views, mote4(), {.line_width_px = 1}).edge_responses);
    const auto four =
        ink_of(make_drawing(scene_views, mote4(), {.line_width_px = 4}).edge_responses);
    EXPECT_LT(one, as_drawn);
    EXPECT_GT(four, 3 * one);
}

TEST(MakeDrawing, ShadingLiesUnderTheLinesInItsColours) {
    DrawOptions options;
    options.shading = shade::ToonParams{};
    options.ink = glm::u8vec3(200, 0, 0);
    options.paper = glm::u8vec3(0, 0, 250);
    const Drawing drawing = make_drawing(small_scene_views(), mote4(), options);
    EXPECT_GT(count_of(drawing.image, {200, 0, 0}), 0);
    EXPECT_GT(count_of(drawing.image, {0, 0, 250}), 0);
    EXPECT_EQ(count_of(drawing.shading, {200, 0, 0}), 0);
    for (std::size_t i = 0; i < drawing.image.size(); ++i) {
        if (drawing.image.data()[i] != glm::u8vec3(200, 0, 0)) {
            EXPECT_EQ(drawing.image.data()[i], drawing.shading.data()[i]);
        }
    }
}

TEST(MakeDrawing, StrokesLieOnPaperUnlessASurfaceIsGiven) {
    DrawOptions options{.shading = shade::StrokeParams{}, .paper = glm::u8vec3(250, 240, 220)};
    EXPECT_EQ(count_of(make_drawing(small_scene_views(), mote4(), options).image, {250, 240, 220}) +
                  count_of(make_drawing(small_scene_views(), mote4(), options).image, kInk.rgb),
              96 * 54);
    options.surface = glm::u8vec3(255, 0, 0);
    EXPECT_GT(count_of(make_drawing(small_scene_views(), mote4(), options).image, {255, 0, 0}), 0);
}

TEST(MakeDrawing, TheImageDoesNotDependOnThreads) {
    const harness::SceneViews scene_views = small_scene_views();
    DrawOptions options{.antialias = 2};
    options.shading = shade::GoochParams{};
    const RgbImage one = make_drawing(scene_views, mote4(), options).image;
    options.threads = 3;
    EXPECT_EQ(make_drawing(scene_views, mote4(), options).image, one);
}

TEST(MakeDrawing, TooLargeASizeIsRefused) {
    EXPECT_THROW((void)make_drawing(small_scene_views(4096, 16), mote4(), {.antialias = 8}),
                 core::Error);
}

}  // namespace
}  // namespace ink::draw
