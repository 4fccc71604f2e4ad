#include "draw/sheet.h"

#include <gtest/gtest.h>

namespace ink::draw {
namespace {

/// A parallel view of 400 by 300 px with a line across it of so many units.
struct Drawn {
    scene::View view{};
    truth::TracedLines lines{};
};

Drawn drawn(double width_units, double height_units) {
    Drawn of;
    of.view.width_px = 400;
    of.view.height_px = 300;
    of.view.camera.height_world = 3 * std::max(width_units, height_units);
    const double px = of.view.height_px / of.view.camera.height_world;
    truth::Curve curve;
    curve.begin = {11, 7, 1};
    curve.end = {11 + width_units * px, 7 + height_units * px, 1};
    of.lines.curves = {curve};
    return of;
}

std::optional<Sheet> on(const char* paper, const Drawn& of, std::optional<double> scale = {}) {
    for (const Paper& each : kPapers)
        if (each.name == paper) return paper_sheet(each, of.view, of.lines, scale);
    return std::nullopt;
}

std::string scale_on(const char* paper, double width, double height) {
    const Drawn of = drawn(width, height);
    return scale_text(mm_per_unit(on(paper, of).value(), of.view));
}

TEST(Sheet, HasTheLargestStandardScaleAtWhichTheLinesFit) {
    EXPECT_EQ(scale_on("A4", 277, 190), "1:1") << "10 mm are free all round";
    EXPECT_EQ(scale_on("A4", 190, 277), "1:1");
    EXPECT_EQ(scale_on("A4", 278, 190), "1:2");
    EXPECT_EQ(scale_on("A4", 555, 10), "1:5");
    EXPECT_EQ(scale_on("A0", 555, 10), "2:1");
    EXPECT_EQ(scale_on("A4", 27700, 10), "1:100");
    EXPECT_EQ(scale_on("A3", 2, 2), "100:1");
    EXPECT_EQ(scale_on("A4", 55, 10), "5:1");
}

TEST(Sheet, LiesAcrossIfThatIsLargerAndHasTheLinesInItsMiddle) {
    const Drawn wide = drawn(200, 100);
    const Sheet sheet = on("A4", wide).value();
    EXPECT_EQ(sheet.width_mm, 297);
    EXPECT_EQ(sheet.height_mm, 210);
    const truth::Curve& line = wide.lines.curves[0];
    EXPECT_NEAR(sheet.left_mm + line.begin.x_px * sheet.mm_per_px, (297 - 200) / 2.0, 1e-9);
    EXPECT_NEAR(sheet.top_mm + line.end.y_px * sheet.mm_per_px, (210 + 100) / 2.0, 1e-9);
    EXPECT_EQ(on("A4", drawn(100, 200)).value().width_mm, 210);
}

TEST(Sheet, TakesTheScaleThatIsAskedForIfTheLinesFit) {
    const Drawn of = drawn(200, 100);
    EXPECT_NEAR(mm_per_unit(on("A4", of, 0.7).value(), of.view), 0.7, 1e-12);
    EXPECT_FALSE(on("A4", of, 2));
    EXPECT_TRUE(on("A2", of, 2));
}

TEST(Sheet, InPerspectiveFillsThePaper) {
    Drawn of = drawn(200, 100);
    of.view.camera.height_world = 0;
    const Sheet sheet = on("A4", of).value();
    const truth::Curve& line = of.lines.curves[0];
    EXPECT_NEAR((line.end.x_px - line.begin.x_px) * sheet.mm_per_px, 277, 1e-9);
}

TEST(Sheet, OfNoLinesIsEmptyPaper) {
    Drawn of = drawn(1, 1);
    of.lines = {};
    EXPECT_EQ(on("A4", of).value().height_mm, 297);
}

TEST(Scale, IsReadAsItIsWritten) {
    for (const char* text : {"1:2", "5:1", "1:1", "1:2500"})
        EXPECT_EQ(scale_text(parse_scale(text).value()), text);
    EXPECT_EQ(parse_scale("0.5"), 0.5);
    for (const char* text : {"", ":", "1:", ":2", "1:0", "0:1", "-1:2", "1:2:3", "a:b", "0", "inf"})
        EXPECT_FALSE(parse_scale(text)) << text;
}

TEST(Sheet, ThatNoPrinterTakesIsDoubted) {
    const auto doubt = [](double w, double h) { return doubt_of_size({w, h, 1}); };
    EXPECT_EQ(doubt(20, 3), "");
    EXPECT_EQ(doubt(19, 3), "smaller than 20 mm");
    EXPECT_EQ(doubt(1189, 841), "");
    EXPECT_EQ(doubt(841, 1189), "");
    EXPECT_EQ(doubt(900, 900), "larger than A0 (1189 x 841 mm)");
    EXPECT_EQ(doubt(1200, 10), "larger than A0 (1189 x 841 mm)");
}

}  // namespace
}  // namespace ink::draw
