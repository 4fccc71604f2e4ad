#include <algorithm>
#include <numbers>

#include "catalogue/shapes.h"
#include "tests/truth/shapes.h"
#include "truth/curve_facts.h"

namespace ink::truth {
namespace {

constexpr double kPx = 0.01;  ///< every expected length holds to this

using Corners = std::array<glm::dvec3, 2>;

/// Expects exactly these edges of the turned cube (object-space corners) in full length.
void expect_cube_edges(const scene::Scene& scene,
                       const Truth& truth,
                       LineClass line_class,
                       const std::vector<Corners>& edges) {
    EXPECT_EQ(edge_lengths(truth, line_class).size(), edges.size()) << name(line_class);
    double sum = 0;
    for (const auto& [a, b] : edges) {
        const auto& m = scene.instances[0].world_from_object;
        const glm::dvec3 a_world(m * glm::dvec4(a, 1)), b_world(m * glm::dvec4(b, 1));
        const double expected = length_px(view_from(6), a_world, b_world);
        sum += expected;
        EXPECT_NEAR(seen_length(scene, truth, a_world, b_world), expected, kPx);
    }
    EXPECT_NEAR(lengths(truth)[line_class], sum, kPx) << name(line_class);
}

TEST(ClosedForm, CubeFromACornerShowsNineEdges) {
    // Turned so that +x, +y and +z all face the eye at (0, 0, 6).
    const glm::dmat4 tilt = glm::rotate(glm::dmat4(1), 0.6, glm::dvec3(1, 0, 0));
    const scene::Scene scene = turned_cube(glm::rotate(tilt, -0.7, glm::dvec3(0, 1, 0)));
    const Truth truth = trace(scene, view_from(6));
    const glm::dvec3 corner{1, 1, 1};
    expect_cube_edges(scene,
                      truth,
                      LineClass::crease,
                      {{corner, {-1, 1, 1}}, {corner, {1, -1, 1}}, {corner, {1, 1, -1}}});
    expect_cube_edges(scene,
                      truth,
                      LineClass::contour,
                      {{{{-1, 1, 1}, {-1, -1, 1}}},
                       {{{-1, -1, 1}, {1, -1, 1}}},
                       {{{1, -1, 1}, {1, -1, -1}}},
                       {{{1, -1, -1}, {1, 1, -1}}},
                       {{{1, 1, -1}, {-1, 1, -1}}},
                       {{{-1, 1, -1}, {-1, 1, 1}}}});
    EXPECT_EQ(truth.curves.size(), 9U);
}

TEST(ClosedForm, CubeFaceOnShowsFourEdges) {
    const scene::Scene scene = turned_cube(glm::dmat4(1));
    const Truth truth = trace(scene, view_from(6));
    // The front face stands 5 in front of the eye: a side of 2 is 600 * 2 / 5 = 240 px.
    EXPECT_EQ(truth.curves.size(), 4U);
    for (const Curve& curve : truth.curves) {
        EXPECT_EQ(curve.line_class, LineClass::contour);
        EXPECT_EQ(curve.kind, ContourKind::sky);
        EXPECT_NEAR(length_px(curve), 240, kPx);
        EXPECT_NEAR(curve.deviation_rad, std::numbers::pi / 2, 1e-6);
        EXPECT_NEAR(curve.begin.w, 5, 1e-9);
    }
}

TEST(ClosedForm, BallOfNSidesAgainstItsCircle) {
    constexpr int kSides = 48, kRings = 24;
    const double distance = 5, radius = 1.5;
    scene::Mesh ball = catalogue::make_sphere(radius, kSides, kRings);
    for (glm::vec3& p : ball.positions)
        p = {p.x, -p.z, p.y};  // its axis is z
    const Truth truth = trace(scene_of({ball}), view_from(distance));
    // From the axis every parallel is a regular polygon; the largest on the image is the contour.
    double r_px = 0;
    for (int ring = 1; ring < kRings; ++ring) {
        const double polar = std::numbers::pi * ring / kRings;
        r_px = std::max(
            r_px, kFocal_px * radius * std::sin(polar) / (distance - radius * std::cos(polar)));
    }
    const double perimeter = kSides * 2 * r_px * std::sin(std::numbers::pi / kSides);
    EXPECT_EQ(truth.curves.size(), static_cast<std::size_t>(kSides));
    EXPECT_NEAR(lengths(truth)[LineClass::contour], perimeter, kPx);
    // The smooth ball's outline is a circle; the polygon lies inside it, by its sagitta at most.
    const double circle_px = kFocal_px * radius / std::sqrt(distance * distance - radius * radius);
    const double step = std::numbers::pi / kRings / 2;
    for (const Curve& curve : truth.curves) {
        const double r = std::hypot(curve.begin.x_px - 320, curve.begin.y_px - 240);
        EXPECT_LT(r, circle_px + kPx);
        EXPECT_GT(r, circle_px * std::cos(step) - 1);
    }
}

TEST(ClosedForm, BoxBehindBoxIsCutWhereTheFrontOneStands) {
    // Both stand face-on: the front one shows x and y in -0.5..0.5 at depth 4, a square of 150 px;
    // the one behind x in -2..2 and y in -0.25..0.25 at depth 8: 300 by 37.5 px.
    const scene::Scene scene =
        scene_of({box({-0.5F, -0.5F, 0}, {0.5F, 0.5F, 1}), box({-2, -0.25F, -4}, {2, 0.25F, -3})});
    const Truth truth = trace(scene, view_from(5));
    const auto [left, right] = std::pair{320.0 - 75, 320.0 + 75};
    std::vector<double> ends;
    for (const Curve& curve : truth.curves) {
        EXPECT_EQ(curve.line_class, LineClass::contour);
        const bool is_long_side_behind = std::abs(curve.begin.w - 8) < 1e-6 &&
                                         std::abs(curve.begin.y_px - curve.end.y_px) < 1e-6;
        if (!is_long_side_behind) continue;
        ends.push_back(std::min(curve.begin.x_px, curve.end.x_px));
        ends.push_back(std::max(curve.begin.x_px, curve.end.x_px));
    }
    std::sort(ends.begin(), ends.end());
    ASSERT_EQ(ends.size(), 8U);
    const std::array expected = {170.0, 170.0, left, left, right, right, 470.0, 470.0};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(ends[i], expected[i], kPx) << i;
    // Four sides in front, two short sides behind, four pieces of the long ones.
    const double total = 4 * 150 + 2 * 37.5 + 4 * 75;
    EXPECT_NEAR(lengths(truth)[LineClass::contour], total, 8 * kPx);
    // The two upright sides of the front box pass 37.5 px of the one behind each.
    const ContourLengths sum = contour_lengths(truth.curves);
    EXPECT_NEAR(sum.other_object_px, 2 * 37.5, 4 * kPx);
    EXPECT_NEAR(sum.sky_px, 4 * 150 - 2 * 37.5 + 2 * 37.5 + 4 * 75, 8 * kPx);
    EXPECT_EQ(sum.self_px, 0);
}

TEST(ClosedForm, TwoCoplanarTilesHaveOneSeamAndSixBoundaries) {
    const scene::Mesh left = quad({-1, -0.5, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {-1, 0.5, 0});
    const scene::Mesh right = quad({0, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0}, {0, 0.5, 0});
    const Truth truth = trace(scene_of({left, right}), view_from(4));
    EXPECT_EQ(edge_lengths(truth, LineClass::seam).size(), 1U);
    EXPECT_EQ(edge_lengths(truth, LineClass::boundary).size(), 6U);
    EXPECT_EQ(truth.curves.size(), 7U);
    EXPECT_NEAR(lengths(truth)[LineClass::seam], 150, kPx);
}

TEST(ClosedForm, GrazingFloorThatFillsTheFrameShowsNothing) {
    // One unit above the floor, half a degree down, rays from 0.1 to 0.9 degrees: 64 to 573 units.
    scene::Mesh floor;
    for (int z = 0; z < 40; ++z) {
        for (int x = -5; x < 5; ++x) {
            const auto p = [&](int dx, int dz) {
                return glm::vec3(20 * (x + dx), 0, -25 * (z + dz));
            };
            add_quad(floor, p(0, 0), p(1, 0), p(1, 1), p(0, 1));
        }
    }
    constexpr double kDegree = std::numbers::pi / 180;
    scene::View view = view_from(1);
    view.camera =
        scene::look_at({0, 1, 0}, {0, 1 - std::tan(0.5 * kDegree), -1}, {0, 1, 0}, 0.8 * kDegree);
    const Truth truth = trace(scene_of({floor}), view);
    EXPECT_TRUE(truth.curves.empty());
    EXPECT_EQ(drawn_px(truth), 0U);
    EXPECT_EQ(std::count(truth.sampled.data(), truth.sampled.data() + truth.sampled.size(), 255),
              0);
    const auto& ids = truth.layers.triangle;
    EXPECT_EQ(std::count(ids.data(), ids.data() + ids.size(), kNoTriangle), 0) << "fills the frame";
}

TEST(ClosedForm, TrianglesThatShareOneVertexShowAllTheirSides) {
    scene::Mesh mesh;
    for (int i = 0; i < 4; ++i) {
        const double turn = i * std::numbers::pi / 2;
        const auto at = [&](double angle) {
            return glm::vec3(std::cos(turn + angle), std::sin(turn + angle), 0);
        };
        add_triangle(mesh, {0, 0, 0}, at(-0.4), at(0.4));
    }
    const Truth truth = trace(scene_of({mesh}), view_from(6));
    // 100 px a unit: two sides of 100 and a base of 200 sin 0.4, four times over.
    EXPECT_EQ(edge_lengths(truth, LineClass::boundary).size(), 12U);
    EXPECT_NEAR(lengths(truth)[LineClass::boundary], 4 * (200 + 200 * std::sin(0.4)), 12 * kPx);
}

TEST(ClosedForm, SliversOfAPlaneShowItsRimOnly) {
    // A strip of needles 1 long and 1e-6 wide, inside a square.
    scene::Mesh mesh;
    constexpr float kThin = 1e-6F;
    float x = 0;
    for (int i = 0; i < 8; ++i) {
        const float next = x + kThin;
        add_quad(mesh, {x, -0.5, 0}, {next, -0.5, 0}, {next, 0.5, 0}, {x, 0.5, 0});
        x = next;
    }
    add_quad(mesh, {-1, -0.5, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {-1, 0.5, 0});
    add_quad(mesh, {x, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0}, {x, 0.5, 0});
    const Truth truth = trace(scene_of({mesh}), view_from(4));
    EXPECT_NEAR(lengths(truth)[LineClass::boundary], 900, 24 * kPx);
    EXPECT_EQ(lengths(truth).size(), 1U);
}

TEST(ClosedForm, CameraInsideABoxSeesItsTwelveCreases) {
    const scene::Scene scene = scene_of({box({-2, -1, -3}, {2, 1, 3})});
    std::map<std::uint32_t, double> seen;
    for (const glm::dvec3 view_direction :
         {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0.1, 1, 0}, {0.1, -1, 0}}) {
        scene::View view = view_from({0.1, 0.2, 0.3}, glm::dvec3(0.1, 0.2, 0.3) + view_direction);
        view.camera.fov_y_rad = 1.9;
        const Truth truth = trace(scene, view);
        for (const Curve& curve : truth.curves)
            EXPECT_EQ(curve.line_class, LineClass::crease);
        for (const auto& [edge, length] : edge_lengths(truth, LineClass::crease))
            seen[edge] += length;
    }
    EXPECT_EQ(seen.size(), 12U);
}

TEST(ClosedForm, NearPlaneCutsWithoutALine) {
    // The near plane at 4 takes the front face away (it stands at 3): the eye looks into the box,
    // sees the back face's rim at depth 5 and the four edges that run from there to the cut.
    const scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    const Truth truth = trace(scene, view_from(4, 4.0));
    const auto by_class = lengths(truth);
    EXPECT_EQ(by_class.size(), 1U);
    const double rim = 4 * kFocal_px * 2 / 5;
    const double slant = std::sqrt(2.0) * (kFocal_px / 4 - kFocal_px / 5);
    EXPECT_NEAR(by_class.at(LineClass::crease), rim + 4 * slant, 8 * kPx);
}

TEST(ClosedForm, WhatStandsBeforeTheNearPlaneHidesNothing) {
    const scene::Mesh mesh = quad({-1, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0}, {-1, 0.5, 0});
    scene::Mesh screen;
    add_quad(screen, {-1, -1, 3.5}, {1, -1, 3.5}, {1, 1, 3.5}, {-1, 1, 3.5});
    const scene::Scene scene = scene_of({mesh, screen});
    EXPECT_NEAR(lengths(trace(scene, view_from(4, 1.0)))[LineClass::boundary], 900, 4 * kPx);
    EXPECT_TRUE(trace(scene, view_from(4, 0.1)).curves.empty()) << "it fills the frame";
}

TEST(ClosedForm, LinesEndAtTheFrame) {
    const scene::Mesh mesh = quad({-100, -0.5, 0}, {100, -0.5, 0}, {100, 0.5, 0}, {-100, 0.5, 0});
    const Truth truth = trace(scene_of({mesh}), view_from(4));
    EXPECT_EQ(truth.curves.size(), 2U);
    EXPECT_NEAR(lengths(truth)[LineClass::boundary], 2.0 * kWidth_px, kPx);
}

}  // namespace
}  // namespace ink::truth
