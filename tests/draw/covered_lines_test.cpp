#include "draw/line_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "draw/sheet.h"
#include "harness/suite/suite.h"
#include "tests/catalogue_names.h"

namespace ink::draw {
namespace {

using truth::Curve;
using truth::LineClass;

constexpr double kWithin_px = 0.1;

Curve piece(glm::dvec2 begin, glm::dvec2 end, LineClass line_class = LineClass::crease) {
    Curve curve;
    curve.line_class = line_class;
    curve.begin = {begin.x, begin.y, 1};
    curve.end = {end.x, end.y, 1};
    return curve;
}

truth::TracedLines cut(std::vector<Curve> visible, std::vector<Curve> hidden = {}) {
    truth::TracedLines lines;
    lines.curves = std::move(visible);
    lines.hidden = std::move(hidden);
    remove_covered(lines, kWithin_px);
    return lines;
}

/// Begin and end along x of each.
std::vector<std::array<double, 2>> along_x(const std::vector<Curve>& curves) {
    std::vector<std::array<double, 2>> places;
    for (const Curve& curve : curves)
        places.push_back({curve.begin.x_px, curve.end.x_px});
    return places;
}
using Places = std::vector<std::array<double, 2>>;

TEST(CoveredLines, AVisiblePieceCoversAHiddenOneWhateverTheClass) {
    const auto lines =
        cut({piece({10, 5}, {0, 5}, LineClass::seam)}, {piece({2, 5}, {8, 5}, LineClass::contour)});
    EXPECT_EQ(lines.curves.size(), 1U);
    EXPECT_TRUE(lines.hidden.empty());
}

TEST(CoveredLines, WhatSticksOutStaysWithItsAttributes) {
    Curve hidden = piece({0, 5}, {20, 5.05});
    hidden.edge = 7;
    hidden.end.w = 3;
    const auto lines = cut({piece({4, 5}, {10, 5})}, {piece({30, 0}, {30, 9}), hidden});
    ASSERT_EQ(lines.hidden.size(), 3U);
    EXPECT_EQ(lines.hidden[0].begin.x_px, 30);
    const Places rest = along_x({lines.hidden[1], lines.hidden[2]});
    EXPECT_NEAR(rest[0][0], 0, 1e-9);
    EXPECT_NEAR(rest[0][1], 4, 1e-3);
    EXPECT_NEAR(rest[1][0], 10, 1e-3);
    EXPECT_NEAR(rest[1][1], 20, 1e-9);
    EXPECT_EQ(lines.hidden[2].edge, 7U);
    EXPECT_NEAR(1 / lines.hidden[2].begin.w, 1 - 2.0 / 3 / 2, 1e-4) << "1/w is affine";
}

TEST(CoveredLines, OfTwoVisibleOnesTheClassOnTopStaysThenTheNearer) {
    const auto classes =
        cut({piece({0, 5}, {10, 5}), piece({0, 5}, {10, 5}, LineClass::contour)}).curves;
    ASSERT_EQ(classes.size(), 1U);
    EXPECT_EQ(classes[0].line_class, LineClass::contour);
    Curve far = piece({0, 5}, {10, 5});
    far.begin.w = far.end.w = 2;
    Curve near = piece({0, 5}, {12, 5});
    near.edge = 3;
    const auto depths = cut({far, near}).curves;
    ASSERT_EQ(depths.size(), 1U);
    EXPECT_EQ(depths[0].edge, 3U);
}

TEST(CoveredLines, PiecesThatMeetCrossOrRunBesideEachOtherStay) {
    const std::vector<Curve> all = {piece({0, 5}, {10, 5}),
                                    piece({10, 5}, {20, 5}),
                                    piece({20, 5}, {20, 9}),
                                    piece({5, 0}, {5, 9}),
                                    piece({0, 5.2}, {10, 5.2}),
                                    piece({0, 4}, {10, 6})};
    EXPECT_EQ(along_x(cut(all).curves), along_x(all));
    EXPECT_EQ(along_x(cut({}, all).hidden), along_x(all));
}

TEST(CoveredLines, APieceSeenEndOnIsNoLine) {
    EXPECT_TRUE(cut({piece({3, 3}, {3, 3})}, {piece({3, 3}, {3, 3})}).curves.empty());
}

struct Segment {
    glm::dvec2 a, b;
};

/// By how much of its length one lies on the other: the same way, and nowhere further off than half
/// of what makes two lines one.
double overlap_mm(const Segment& s, const Segment& t) {
    constexpr double kApart_mm = 0.01, kSine = 0.05;
    const double length = glm::distance(s.a, s.b);
    const glm::dvec2 u = (s.b - s.a) / length, v(-u.y, u.x), way = t.b - t.a;
    if (std::abs(glm::dot(v, way)) > kSine * glm::length(way)) return 0;
    const double one = glm::dot(u, t.a - s.a), two = glm::dot(u, t.b - s.a);
    const double from = std::max(0.0, std::min(one, two));
    const double to = std::min(length, std::max(one, two));
    if (to <= from) return 0;
    const auto apart = [&](double at) {
        return std::abs(glm::dot(v, t.a + (at - one) / (two - one) * way - s.a));
    };
    return apart(from) <= kApart_mm && apart(to) <= kApart_mm ? to - from : 0;
}

/// Over all pairs, once each: those whose ranges of x meet.
double overlap_mm(std::vector<Segment> all) {
    for (Segment& s : all)
        if (s.b.x < s.a.x) std::swap(s.a, s.b);
    std::erase_if(all, [](const Segment& s) { return s.a == s.b; });
    std::ranges::sort(all, {}, [](const Segment& s) { return s.a.x; });
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size() && all[j].a.x <= all[i].b.x + 0.01; ++j)
            sum += overlap_mm(all[i], all[j]);
    }
    return sum;
}

std::vector<Segment> on_sheet(const DrawnLines& lines, const Sheet& sheet) {
    std::vector<Segment> segments;
    for (const auto* some : {&lines.visible, &lines.hidden}) {
        for (const truth::Polyline& line : *some) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const auto place = [&](const truth::CurvePoint& p) {
                    return glm::dvec2(p.x_px, p.y_px) * sheet.mm_per_px;
                };
                segments.push_back({place(line.points[i - 1]), place(line.points[i])});
            }
        }
    }
    return segments;
}

TEST(CoveredLines, NothingLiesOnAnythingInDrawingsOfTheCatalogue) {
    harness::ViewRequest request{640, 360};
    for (const char* name : {"front", "top", "iso"}) {
        for (const scene::NamedDirection& view : scene::drawing_views())
            if (view.name == name) request.directions.push_back(view);
    }
    double before_mm = 0;
    for (const std::string& name : light_scene_names()) {
        const auto of = harness::make_scene_views(harness::load_scene(name), request);
        const truth::Model model = truth::build_model(of.scene, {});
        for (const scene::View& view : of.views) {
            auto lines = trace_drawn_lines(model, view, {.threads = 2}, truth::Hidden::keep);
            const Sheet sheet = paper_sheet(kPapers[0], view, lines, std::nullopt).value();
            before_mm += overlap_mm(on_sheet(joined_by_class(lines), sheet));
            remove_covered(lines, same_line_px(sheet));
            EXPECT_LT(overlap_mm(on_sheet(joined_by_class(lines), sheet)), 0.02)
                << name << ' ' << view.camera.name;
        }
    }
    EXPECT_GT(before_mm, 1000) << "there is much to cover";
}

}  // namespace
}  // namespace ink::draw
