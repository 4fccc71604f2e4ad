#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <sstream>

#include "draw/line_drawing.h"

namespace ink::draw {
namespace {

using truth::LineClass;

/// By layer or group the points of each line, in 1/10000 mm, y down; a closed one ends where it
/// begins.
using Points = std::vector<std::pair<long, long>>;
using Lines = std::map<std::string, std::vector<Points>>;

constexpr double kHeight_mm = 75;

long steps(double mm) {
    return std::lround(mm * 10000);
}

struct Group {
    int code = 0;
    std::string value;
};

std::vector<Group> groups_of(const std::string& dxf) {
    std::istringstream text(dxf);
    std::vector<Group> groups;
    for (std::string code, value; std::getline(text, code) && std::getline(text, value);)
        groups.push_back({std::stoi(code), value});
    return groups;
}

Lines lines_of_dxf(const std::string& dxf) {
    Lines lines;
    std::string entity, section, layer;
    bool is_closed = false;
    Points points;
    const auto end_line = [&] {
        if (is_closed) points.push_back(points.front());
        if (!points.empty()) lines[layer].push_back(points);
        points.clear();
        is_closed = false;
    };
    double x = 0;
    for (const auto& [code, value] : groups_of(dxf)) {
        const bool is_point = entity == "LINE" || entity == "VERTEX";
        if (code == 0) {
            if (value == "LINE" || value == "POLYLINE" || value == "ENDSEC") end_line();
            entity = value;
        } else if (code == 2 && entity == "SECTION") {
            section = value;
        } else if (code == 8) {
            layer = value;
        } else if (code == 70 && entity == "POLYLINE") {
            is_closed = value == "1";
        } else if ((code == 10 || code == 11) && is_point) {
            x = std::stod(value);
        } else if ((code == 20 || code == 21) && is_point) {
            EXPECT_EQ(section, "ENTITIES");
            points.emplace_back(steps(x), steps(kHeight_mm) - steps(std::stod(value)));
        }
    }
    return lines;
}

Lines lines_of_svg(const std::string& svg) {
    Lines lines;
    const std::regex shape("<(polyline|polygon) id=\"([a-z-]+)-[0-9]+\" points=\"([^\"]*)\"");
    for (std::sregex_iterator it(svg.begin(), svg.end(), shape), end; it != end; ++it) {
        std::string layer = (*it)[2];
        std::ranges::transform(layer, layer.begin(), [](unsigned char c) { return toupper(c); });
        Points points;
        std::istringstream pairs((*it)[3]);
        for (std::string pair; pairs >> pair;) {
            const std::size_t comma = pair.find(',');
            points.emplace_back(steps(std::stod(pair)), steps(std::stod(pair.substr(comma + 1))));
        }
        if ((*it)[1] == "polygon") points.push_back(points.front());
        lines[layer].push_back(points);
    }
    return lines;
}

truth::Polyline line(LineClass line_class, std::vector<truth::CurvePoint> points) {
    truth::Polyline polyline;
    polyline.line_class = line_class;
    polyline.points = std::move(points);
    return polyline;
}

DrawnLines some_lines() {
    return {
        {line(LineClass::crease, {{0, 0, 1}, {100, 7, 1}}),
         line(LineClass::contour, {{0, 0, 1}, {200, 0, 1}, {200, 40, 1}, {0, 40, 1}, {0, 0, 1}}),
         line(LineClass::seam, {{1.0 / 3, 2.0 / 3, 1}, {9, 9, 1}, {80, 30, 1}, {1, 2, 1}})},
        {line(LineClass::crease, {{4, 0, 1}, {8, 0, 1}}),
         line(LineClass::boundary, {{4, 9, 1}, {8, 10, 1}, {8, 30, 1}})}};
}

scene::View view() {
    scene::View view;
    view.camera.name = "front";
    view.width_px = 400;
    view.height_px = 300;
    return view;
}

TEST(DxfDrawing, HoldsTheLinesOfTheSvgByLayer) {
    Sheet sheet = image_sheet(view(), 100);
    ASSERT_EQ(sheet.height_mm, kHeight_mm);
    sheet.left_mm = 3;
    sheet.top_mm = -2.5;
    const Lines found = lines_of_dxf(dxf_drawing(some_lines(), "cube", view(), sheet));
    EXPECT_EQ(found, lines_of_svg(line_drawing(some_lines(), "cube", view(), sheet)));
    EXPECT_EQ(found.size(), 5U);
    EXPECT_EQ(found.at("HIDDEN-CREASE"), (std::vector<Points>{{{40000, -25000}, {50000, -25000}}}));
}

TEST(DxfDrawing, IsReleaseTwelveWithALayerPerClass) {
    const std::string dxf =
        dxf_drawing(some_lines(), "k\xc3\xbc\nbe", view(), image_sheet(view(), 100));
    EXPECT_TRUE(
        std::ranges::all_of(dxf, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    std::map<std::string, std::string> types;
    std::string entity, name;
    const auto groups = groups_of(dxf);
    for (const auto& [code, value] : groups) {
        if (code == 0) entity = value;
        if (code == 2) name = value;
        if (code == 6 && entity == "LAYER") types[name] = value;
    }
    EXPECT_EQ(types.size(), 10U);
    EXPECT_EQ(types["CONTOUR"], "CONTINUOUS");
    EXPECT_EQ(types["HIDDEN-SEAM"], "HIDDEN");
    EXPECT_EQ(groups.front().value, "k???be front, in mm");
    EXPECT_EQ(groups[4].value, "AC1009");
    EXPECT_EQ(groups.back().value, "EOF");
}

TEST(DxfDrawing, OfNothingHasNoEntity) {
    EXPECT_TRUE(lines_of_dxf(dxf_drawing({}, "", view(), image_sheet(view(), 100))).empty());
}

}  // namespace
}  // namespace ink::draw
