#include "draw/line_drawing.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "tests/report/markup.h"

namespace ink::draw {
namespace {

using testing::HasSubstr;
using testing::Not;
using truth::LineClass;

truth::Polyline line(LineClass line_class, std::vector<truth::CurvePoint> points) {
    truth::Polyline polyline;
    polyline.line_class = line_class;
    polyline.points = std::move(points);
    return polyline;
}

scene::View view() {
    scene::View view;
    view.camera.name = "front";
    view.width_px = 400;
    view.height_px = 300;
    return view;
}

DrawnLines square() {
    DrawnLines lines;
    lines.visible = {
        line(LineClass::crease, {{0, 0, 1}, {100, 0, 1}}),
        line(LineClass::contour, {{0, 0, 1}, {200, 0, 1}, {200, 40, 1}, {0, 40, 1}, {0, 0, 1}}),
        line(LineClass::crease, {{0, 0, 1}, {0, 100, 1}})};
    return lines;
}

std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

TEST(LineDrawing, HasAGroupPerClassInMillimetres) {
    const std::string svg = line_drawing(square(), "a <b> & c", view(), image_sheet(view(), 100));
    EXPECT_EQ(report::nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(R"(viewBox="0 0 100 75" width="100mm" height="75mm")"));
    EXPECT_THAT(svg, HasSubstr("<title>a &lt;b&gt; &amp; c front</title>"));
    EXPECT_EQ(all_of(svg, "<g id=\"([a-z-]+)\""),
              (std::vector<std::string>{"seam", "intersection", "crease", "boundary", "contour"}));
    EXPECT_THAT(svg, HasSubstr(R"(<polyline id="crease-1" points="0,0 25,0"/>)"));
    EXPECT_THAT(svg, HasSubstr(R"(<polyline id="crease-2" points="0,0 0,25"/>)"));
    EXPECT_THAT(svg, HasSubstr(R"(<polygon id="contour-1" points="0,0 50,0 50,10 0,10"/>)"));
    EXPECT_THAT(svg, Not(HasSubstr("dash")));
}

TEST(LineDrawing, DashesHiddenLinesBelowTheOthers) {
    DrawnLines lines = square();
    lines.hidden = {line(LineClass::crease, {{4, 0, 1}, {8, 0, 1}})};
    const std::string svg = line_drawing(lines, "cube", view(), image_sheet(view(), 100));
    EXPECT_EQ(report::nesting_error(svg), "");
    const auto groups = all_of(svg, "<g id=\"([a-z-]+)\"");
    ASSERT_EQ(groups.size(), 10U);
    EXPECT_EQ(groups.front(), "hidden-seam");
    EXPECT_EQ(groups.back(), "contour");
    EXPECT_EQ(all_of(svg, "(stroke-dasharray)").size(), 5U);
    EXPECT_THAT(svg, HasSubstr(R"(<polyline id="hidden-crease-1" points="1,0 2,0"/>)"));
    const auto ids = all_of(svg, " id=\"([a-z0-9-]+)\"");
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(LineDrawing, OfNothingIsAnEmptySheet) {
    const std::string svg =
        line_drawing({}, "nothing", view(), image_sheet(view(), usual_sheet_mm(400)));
    EXPECT_EQ(report::nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(R"(width="105.8333mm" height="79.375mm")"));
    EXPECT_THAT(svg, Not(HasSubstr("points")));
}

}  // namespace
}  // namespace ink::draw
