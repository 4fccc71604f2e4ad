// Strokes and chords: what their ink is, by closed forms, and laws over both.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catalogue/shapes.h"
#include "methods/antialias.h"
#include "score/coverage.h"
#include "tests/edge/guarded.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr std::array<const char*, 2> kMethods = {"strokes", "chords"};

/// The exact ink of straight lines, of 255.
core::Image<float> exact_ink(const std::vector<std::array<glm::dvec2, 2>>& lines,
                             std::pair<int, int> size_px,
                             double width_px) {
    std::vector<truth::Curve> curves(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        curves[i].begin = {lines[i][0].x, lines[i][0].y, 1};
        curves[i].end = {lines[i][1].x, lines[i][1].y, 1};
    }
    return core::mapped<float>(
        score::draw_coverage(curves, size_px.first, size_px.second, width_px),
        [](float share) { return 255 * share; });
}

/// The greatest difference from the exact ink, of 255, over pixels that lie so far from corners.
double worst_off(const edge::EdgeImage& image,
                 const core::Image<float>& exact,
                 const std::vector<glm::dvec2>& corners,
                 double away_px) {
    double worst = 0;
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            const glm::dvec2 at{x + 0.5, y + 0.5};
            const bool is_near = std::any_of(corners.begin(), corners.end(), [&](const auto& p) {
                return glm::length(p - at) < away_px;
            });
            if (!is_near)
                worst = std::max<double>(worst, std::abs(image.at(x, y) - exact.at(x, y)));
        }
    }
    return worst;
}

/// A polygon in a plane that faces the eye, its corners at places of the image.
struct SeenPolygon {
    std::vector<glm::dvec2> corners;
    int width_px = 100, height_px = 80;

    [[nodiscard]] scene::View view() const { return face_on(width_px, height_px); }
    [[nodiscard]] scene::Scene scene() const {
        const double unit = 4 / scene::Projection(view()).focal_px();
        scene::Mesh mesh;
        for (const glm::dvec2& p : corners)
            mesh.positions.push_back({static_cast<float>((p.x - width_px / 2.0) * unit),
                                      static_cast<float>((height_px / 2.0 - p.y) * unit),
                                      0});
        for (std::uint32_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({0, i, i - 1});
        return scene_of({mesh});
    }
    [[nodiscard]] std::vector<std::array<glm::dvec2, 2>> sides() const {
        std::vector<std::array<glm::dvec2, 2>> lines;
        for (std::size_t i = 0; i < corners.size(); ++i)
            lines.push_back({corners[i], corners[(i + 1) % corners.size()]});
        return lines;
    }
    [[nodiscard]] edge::EdgeImage drawn_by(const std::string& method, double line_px) const {
        return drawn(method, {{"width_px", std::to_string(line_px)}}, scene(), {view(), 1});
    }
};

/// A square turned by any angle, and a polygon of many sides: what is seen of a ball.
SeenPolygon regular(int count, double radius_px, double turn_rad) {
    SeenPolygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = turn_rad + 2 * std::numbers::pi * i / count;
        polygon.corners.push_back(glm::dvec2(50.3, 39.6) +
                                  radius_px * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

TEST(GreyLines, InkIsTheExactShareOfEveryPixelButAtCorners) {
    for (const std::string method : kMethods) {
        for (const double turn_rad : {0.0, 0.2, std::numbers::pi / 4, 1.1}) {
            for (const double width_px : {1.0, 1.5, 2.0, 4.0}) {
                const SeenPolygon square = regular(4, 30, turn_rad);
                const auto exact = exact_ink(square.sides(), {100, 80}, width_px);
                const auto image = square.drawn_by(method, width_px);
                // A byte of place is 1/510 px.
                EXPECT_LE(worst_off(image, exact, square.corners, width_px / 2 + 2), 2.0)
                    << method << ' ' << turn_rad << ' ' << width_px;
                // At corners one straight side stands for the round end of a pen; chords cut them
                // off.
                EXPECT_LE(worst_off(image, exact, {}, 0), method == "strokes" ? 20 : 132)
                    << method << ' ' << turn_rad << ' ' << width_px;
            }
        }
    }
}

TEST(GreyLines, APolygonOfManySidesIsDrawnWhole) {
    const SeenPolygon ball = regular(60, 33, 0.1);
    for (const std::string method : kMethods) {
        for (const double width_px : {1.0, 2.0, 3.0}) {
            const auto exact = exact_ink(ball.sides(), {100, 80}, width_px);
            EXPECT_LE(worst_off(ball.drawn_by(method, width_px), exact, {}, 0),
                      method == "strokes" ? 4 : 24)
                << method << ' ' << width_px;
        }
    }
}

TEST(GreyLines, ChordsLessThanTwoPixelsApartStayTwoAtHalf) {
    SeenPolygon bar;
    bar.corners = {{20.3, 40.9}, {80.7, 40.9}, {80.7, 42.3}, {20.3, 42.3}};
    const auto ink = bar.drawn_by("chords", 1);
    for (int x = 30; x < 70; ++x) {
        EXPECT_NEAR(ink.at(x, 40), 153, 2);
        EXPECT_EQ(ink.at(x, 41), 104);
        EXPECT_NEAR(ink.at(x, 42), 204, 2);
    }
    EXPECT_GT(bar.drawn_by("chords", 1.1).at(50, 41), 153);
}

TEST(GreyLines, ChordsOfBumpsSmallerThanAPixelStayAtHalf) {
    scene::Mesh ball = catalogue::make_icosphere(1, 6);
    for (std::size_t i = 0; i < ball.positions.size(); i += 97)
        ball.positions[i] *= 1.03F;
    const scene::Scene scene = scene_of({std::move(ball)});
    int seen_px = 0;
    for (const double distance : {5.0, 5.5, 6.0, 6.5}) {
        const scene::View view = view_from(scene, {0, 0, distance}, {0, 0, 0}, {100, 80});
        const auto seen = drawn("surface_lookup", {}, scene, {view, 1});
        const auto ink = drawn("chords", {}, scene, {view, 1});
        for (int at = 0; at < 40 * 40; ++at) {
            const int x = 30 + at % 40, y = 20 + at / 40;
            if (seen.at(x, y) == 0) continue;
            ++seen_px;
            int most = 0;
            for (int i = 0; i < 25; ++i)
                most = std::max<int>(most, ink.at(x - 2 + i % 5, y - 2 + i / 5));
            EXPECT_GE(most, 110) << distance << ": " << x << ' ' << y;
        }
    }
    EXPECT_GT(seen_px, 1000);
}

TEST(GreyLines, ALineJustOutsideTheFrameReachesIn) {
    SeenPolygon wall;
    wall.corners = {{-0.75, 20.25}, {120.4, 20.25}, {120.4, 90}, {-0.75, 90}};
    for (const std::string method : kMethods) {
        const auto exact = exact_ink(wall.sides(), {100, 80}, 2);
        ASSERT_GT(exact.at(0, 50), 60);
        EXPECT_LE(worst_off(wall.drawn_by(method, 2), exact, wall.corners, 3), 2.0) << method;
    }
}

/// A cube on a floor, a ball that a plate cuts, and a fan of three faces at one edge.
scene::Scene varied() {
    scene::Scene scene = cube_on_floor();
    scene.meshes.push_back(catalogue::make_icosphere(0.7, 3));
    scene::Mesh fan;
    fan.positions = {
        {0, -0.9F, 0}, {0, 0.9F, 0}, {0.8F, 0, 0}, {-0.5F, 0, 0.6F}, {-0.4F, 0, -0.7F}};
    fan.triangles = {{0, 2, 1}, {0, 3, 1}, {0, 4, 1}};
    scene.meshes.push_back(fan);
    scene.instances.push_back({2, glm::translate(glm::dmat4(1), {1.9, -0.6, 0.4}), "ball"});
    scene.instances.push_back({3, glm::translate(glm::dmat4(1), {-1.9, 0.1, 0.9}), "fan"});
    return scene;
}

scene::View view_of(const scene::Scene& scene,
                    scene::ProjectionKind projection = scene::ProjectionKind::perspective) {
    return view_from(scene, {4, 3, 6}, {0, 0, 0}, {211, 160}, projection);
}

TEST(GreyLines, AreTheSameBitsOnEveryThreadCountAndTarget) {
    const scene::Scene scene = varied();
    for (const auto projection :
         {scene::ProjectionKind::perspective, scene::ProjectionKind::parallel}) {
        const scene::View view = view_of(scene, projection);
        for (const std::string method : kMethods) {
            for (const core::ParamValues& values :
                 {core::ParamValues{},
                  {{"width_px", "4"}, {"far_width", "0.1"}, {"creases", "0.3"}}}) {
                const auto expected = drawn(method, values, scene, {view, 1});
                EXPECT_EQ(drawn(method, values, scene, {view, 3}), expected) << method;
                edge::on_every_target([&] {
                    EXPECT_EQ(drawn(method, values, scene, {view, 1}), expected) << method;
                });
            }
        }
    }
}

TEST(GreyLines, AWiderPenCoversWhatANarrowerDoes) {
    const scene::Scene scene = varied();
    const scene::View view = view_of(scene);
    for (const std::string method : kMethods) {
        edge::EdgeImage last(view.width_px, view.height_px, 0);
        for (const char* width_px : {"1", "1.5", "2", "3", "4"}) {
            const auto image = drawn(method, {{"width_px", width_px}}, scene, {view, 1});
            int less = 0;
            for (std::size_t i = 0; i < image.size(); ++i)
                less += image.data()[i] < last.data()[i] ? 1 : 0;
            EXPECT_EQ(less, 0) << method << ' ' << width_px;
            last = image;
        }
    }
}

double ink_in(const edge::EdgeImage& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.size(); ++i)
        sum += image.data()[i];
    return sum;
}

TEST(GreyLines, ClassesAndDistanceSayHowWide) {
    const scene::Scene scene = varied();
    const scene::View view = view_of(scene);
    for (const std::string method : kMethods) {
        const auto with = [&](const core::ParamValues& values) {
            return ink_in(drawn(method, values, scene, {view, 1}));
        };
        const core::ParamValues none = {
            {"contours", "0"}, {"creases", "0"}, {"intersections", "0"}, {"seams", "0"}};
        EXPECT_EQ(with(none), 0) << method;
        core::ParamValues creases = none;
        creases["creases"] = "1";
        EXPECT_GT(with(creases), 0.1 * with({})) << method;
        EXPECT_LT(with(creases), 0.7 * with({})) << method;
        // Nothing is so near that it is not narrower, or so far that it is the narrowest.
        EXPECT_LT(with({{"far_width", "0.5"}}), 0.95 * with({})) << method;
        EXPECT_GT(with({{"far_width", "0.5"}}), 0.5 * with({})) << method;
        EXPECT_EQ(with({{"far_width", "0.5"}, {"near_at", "1"}}), with({})) << method;
    }
}

TEST(GreyLines, NarrowPartsAreFollowedWhereNoSampleIs) {
    // A needle that is narrower than the distance of samples over most of its length.
    SeenPolygon needle;
    needle.corners = {{10.2, 30.4}, {90.7, 41.3}, {10.4, 33.6}};
    const auto exact = exact_ink(needle.sides(), {100, 80}, 1);
    const auto image = needle.drawn_by("strokes", 1);
    double apart = 0, all = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        apart += std::abs(static_cast<double>(image.data()[i] - exact.data()[i]));
        all += exact.data()[i];
    }
    EXPECT_LT(apart, 0.02 * all);
}

TEST(GreyLines, PartsThatJoinInAPlaneHaveNoLineBetweenThem) {
    // A corner of the lower two lies on the upper one's border; what stands before them shows it.
    scene::Mesh parts, whole, before;
    parts.positions = {{-1, 1, 0},
                       {1, 1, 0},
                       {1, 0.1, 0},
                       {-1, 0.1, 0},
                       {0, 0.1, 0},
                       {-1, -1, 0},
                       {0, -1, 0},
                       {1, -1, 0}};
    parts.triangles = {{3, 2, 1}, {3, 1, 0}, {5, 6, 4}, {5, 4, 3}, {6, 7, 2}, {6, 2, 4}};
    whole.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    before.positions = {{-0.43, -0.5, 0.3}, {0.31, -0.5, 0.3}, {0.31, 0.6, 0.3}, {-0.43, 0.6, 0.3}};
    whole.triangles = before.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene::View view;
    view.camera = scene::look_at({0.7, 0.5, 5}, {0, 0, 0.15}, {0.15, 1, 0}, 0.5236);
    view.width_px = 320;
    view.height_px = 180;
    for (const std::string method : kMethods) {
        const auto joined = drawn(method, {}, scene_of({parts, before}), {view, 1});
        const auto one = drawn(method, {}, scene_of({whole, before}), {view, 1});
        int apart_px = 0;
        for (std::size_t i = 0; i < one.size(); ++i)
            apart_px += std::abs(joined.data()[i] - one.data()[i]) > 4 ? 1 : 0;
        EXPECT_LE(apart_px, 8) << method << ": of a border of 100 px";
    }
}

}  // namespace
}  // namespace ink::methods
