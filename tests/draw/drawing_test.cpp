#include "draw/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "draw/palette.h"

namespace ink::draw {
namespace {

/// The catalogue's cube, seen small: enough for lines.
harness::Subject small_subject(int width_px = 96, int height_px = 54) {
    harness::ViewRequest request;
    request.width_px = width_px;
    request.height_px = height_px;
    return harness::load_one_view("cube", "", request);
}

harness::Entrant mote4() {
    return harness::make_entrants("mote4", {}).front();
}

std::ptrdiff_t count_of(const RgbImage& picture, const glm::u8vec3& color) {
    return std::count(picture.data(), picture.data() + picture.size(), color);
}

std::ptrdiff_t ink_of(const edge::EdgeImage& strengths) {
    return std::count_if(
        strengths.data(), strengths.data() + strengths.size(), [](int s) { return s > 0; });
}

TEST(MakeDrawing, PlainIsInkOnPaperWhereStrengthsAreFull) {
    const Drawing drawing = make_drawing(small_subject(), mote4(), {});
    const auto ink = count_of(drawing.picture, kInk.rgb);
    EXPECT_GT(ink, 0);
    EXPECT_EQ(ink + count_of(drawing.picture, kPaper.rgb), 96 * 54);
    EXPECT_TRUE(drawing.shading.is_empty());
}

TEST(MakeDrawing, KeepsTheSizeOfTheViewWhenAntialiased) {
    const Drawing drawing = make_drawing(small_subject(), mote4(), {.antialias = 3});
    EXPECT_EQ(drawing.picture.width_px(), 96);
    EXPECT_EQ(drawing.strengths.height_px(), 54);
    const auto plain = count_of(drawing.picture, kInk.rgb) + count_of(drawing.picture, kPaper.rgb);
    EXPECT_LT(plain, 96 * 54) << "no shades between ink and paper";
}

TEST(MakeDrawing, AWidthOfOneIsThinnedAndWiderHasMoreInk) {
    const harness::Subject subject = small_subject();
    const auto as_drawn = ink_of(make_drawing(subject, mote4(), {}).strengths);
    const auto one = ink_of(make_drawing(subject, mote4(), {.line_width_px = 1}).strengths);
    const auto four = ink_of(make_drawing(subject, mote4(), {.line_width_px = 4}).strengths);
    EXPECT_LT(one, as_drawn);
    EXPECT_GT(four, 3 * one);
}

TEST(MakeDrawing, ShadingLiesUnderTheLinesInItsColours) {
    DrawOptions options;
    options.shading = shade::ToonParams{};
    options.ink = glm::u8vec3(200, 0, 0);
    options.paper = glm::u8vec3(0, 0, 250);
    const Drawing drawing = make_drawing(small_subject(), mote4(), options);
    EXPECT_GT(count_of(drawing.picture, {200, 0, 0}), 0);
    EXPECT_GT(count_of(drawing.picture, {0, 0, 250}), 0);
    EXPECT_EQ(count_of(drawing.shading, {200, 0, 0}), 0);
    for (std::size_t i = 0; i < drawing.picture.size(); ++i) {
        if (drawing.picture.data()[i] != glm::u8vec3(200, 0, 0)) {
            EXPECT_EQ(drawing.picture.data()[i], drawing.shading.data()[i]);
        }
    }
}

TEST(MakeDrawing, StrokesLieOnPaperUnlessASurfaceIsGiven) {
    DrawOptions options;
    options.shading = shade::StrokeParams{};
    options.paper = glm::u8vec3(250, 240, 220);
    EXPECT_EQ(count_of(make_drawing(small_subject(), mote4(), options).picture, {250, 240, 220}) +
                  count_of(make_drawing(small_subject(), mote4(), options).picture, kInk.rgb),
              96 * 54);
    options.surface = glm::u8vec3(255, 0, 0);
    EXPECT_GT(count_of(make_drawing(small_subject(), mote4(), options).picture, {255, 0, 0}), 0);
}

TEST(MakeDrawing, TheHandFollowsItsSeed) {
    const harness::Subject subject = small_subject();
    DrawOptions options{.hand = shade::HandParams{}, .seed = 4};
    const RgbImage one = make_drawing(subject, mote4(), options).picture;
    EXPECT_EQ(make_drawing(subject, mote4(), options).picture, one);
    options.seed = 5;
    EXPECT_NE(make_drawing(subject, mote4(), options).picture, one);
}

TEST(MakeDrawing, ThePictureDoesNotDependOnThreads) {
    const harness::Subject subject = small_subject();
    DrawOptions options{.hand = shade::HandParams{}, .antialias = 2};
    options.shading = shade::GoochParams{};
    const RgbImage one = make_drawing(subject, mote4(), options).picture;
    options.threads = 3;
    EXPECT_EQ(make_drawing(subject, mote4(), options).picture, one);
}

TEST(MakeDrawing, TooLargeASizeIsRefused) {
    EXPECT_THROW((void)make_drawing(small_subject(4096, 16), mote4(), {.antialias = 8}),
                 core::Error);
}

}  // namespace
}  // namespace ink::draw
