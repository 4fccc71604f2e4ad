#include <numbers>

#include "catalogue/shapes.h"
#include "tests/truth/shapes.h"
#include "truth/crossings/crossings.h"

namespace ink::truth {
namespace {

constexpr double kPx = 0.01;

double world_length(const Crossings& crossings) {
    double sum = 0;
    for (const Crossing& c : crossings.segments)
        sum += glm::length(c.end_world - c.begin_world);
    return sum;
}

TEST(Crossing, BoxesSunkIntoEachOther) {
    // What both fill is [0, 1] x [0.25, 1] x [0.5, 1]; six of its edges lie on a face of each.
    const glm::vec3 move{1.5F, -2, 0};
    const scene::Scene scene =
        scene_of({box(glm::vec3(-1, -1, -1) + move, glm::vec3(1, 1, 1) + move),
                  box(glm::vec3(0, 0.25F, 0.5F) + move, glm::vec3(2, 2.25F, 2.5F) + move)});
    const Crossings found = find_crossings(scene::weld(scene), {});
    EXPECT_NEAR(world_length(found), 2 * (1 + 0.75 + 0.5), 1e-9);
    EXPECT_TRUE(found.contacts.empty());
    EXPECT_TRUE(found.coplanar.empty());

    // From the upper left the wall x = 0 of the second stands on the top and the front of the
    // first.
    const Truth truth = trace(scene, view_from(8));
    const glm::dvec3 m(move);
    const double expected =
        length_px(view_from(8), glm::dvec3(0, 1, 0.5) + m, glm::dvec3(0, 1, 1) + m) +
        length_px(view_from(8), glm::dvec3(0, 1, 1) + m, glm::dvec3(0, 0.25, 1) + m);
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], expected, kPx);
    EXPECT_EQ(truth.counts.crossings, found.segments.size());
    EXPECT_GT(truth.counts.pairs_tested, found.segments.size());
}

/// A wall in z = 0 and a strip of height 1 through it, whose halves meet in its line x = 0: the
/// left one lies before the wall and rises from it with slope `left`, the right one behind it.
scene::Scene strip_through_wall(float left, float right, bool is_one_object) {
    scene::Mesh wall, strip;
    add_quad(wall, {-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0});
    add_quad(strip, {-1, -0.5F, left}, {0, -0.5F, 0}, {0, 0.5F, 0}, {-1, 0.5F, left});
    add_quad(strip, {0, -0.5F, 0}, {1, -0.5F, -right}, {1, 0.5F, -right}, {0, 0.5F, 0});
    return is_one_object ? scene_of({joined({wall, strip})}) : scene_of({wall, strip});
}

TEST(Crossing, AtAnEdgeOfTheStripItIsOneAtAnyAngle) {
    // From 6 away the joint is 100 px long. The strip leaves the wall by 27 degrees, less than a
    // crease, and goes on behind it flat, or bent by another 27 (no crease) or 50 degrees (one).
    for (const float right : {0.5F, 1.5F, 5.0F}) {
        for (const bool is_one_object : {true, false}) {
            const Truth truth = trace(strip_through_wall(0.5F, right, is_one_object), view_from(6));
            EXPECT_NEAR(lengths(truth)[LineClass::intersection], 100, kPx) << right;
            EXPECT_EQ(lengths(truth)[LineClass::seam], 0) << right;
            EXPECT_EQ(lengths(truth)[LineClass::crease], 0) << right;
        }
    }
}

TEST(Crossing, AStripThatEndsInAWallGoesOnInIt) {
    const scene::Mesh wall = quad({-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0});
    const scene::Mesh strip =
        quad({-1, -0.5F, 0.5F}, {0, -0.5F, 0}, {0, 0.5F, 0}, {-1, 0.5F, 0.5F});
    const Truth truth = trace(scene_of({wall, strip}), view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::seam], 100, kPx);
    EXPECT_EQ(lengths(truth)[LineClass::intersection], 0);
}

TEST(Crossing, BoxSunkInAFloorHasAFootAllRound) {
    const scene::Mesh floor = quad({-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5});
    const scene::Scene scene = scene_of({floor, box({-1, -0.5F, -1}, {1, 2, 1})});
    EXPECT_NEAR(world_length(find_crossings(scene::weld(scene), {})), 8, 1e-9);
    const scene::View view = view_from({3, 4, 12}, {0, 1, 0});
    const Truth truth = trace(scene, view);
    EXPECT_NEAR(lengths(truth)[LineClass::intersection],
                length_px(view, {-1, 0, 1}, {1, 0, 1}) + length_px(view, {1, 0, 1}, {1, 0, -1}),
                kPx);
    EXPECT_EQ(seen_length(scene, truth, {-1, -0.5, 1}, {1, -0.5, 1}), 0) << "it is below the floor";
    for (const Curve& curve : truth.curves) {
        if (curve.line_class != LineClass::intersection) continue;
        EXPECT_EQ(curve.edge, kNoEdge);
        EXPECT_LT(curve.face0, 2U) << "of the floor";
        EXPECT_GE(curve.face1, 2U);
        EXPECT_NEAR(curve.deviation_rad, std::numbers::pi / 2, 1e-6);
    }
}

TEST(Crossing, BoxOnAFloorKeepsItsContourAndNothingIsDoubled) {
    const scene::Mesh floor = quad({-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5});
    const scene::Scene scene = scene_of({floor, box({-1, 0, -1}, {1, 2, 1})});
    const Truth truth = trace(scene, view_from({3, 4, 12}, {0, 1, 0}));
    EXPECT_EQ(lengths(truth).count(LineClass::intersection), 0U);
    EXPECT_EQ(lengths(truth).count(LineClass::seam), 0U);
    EXPECT_EQ(truth.counts.crossings, 0U);
    const scene::Topology topology = scene::weld(scene);
    for (const Curve& curve : truth.curves) {
        const scene::Edge& edge = topology.edges[curve.edge];
        if (topology.p_world[edge.a].y != 0 || topology.p_world[edge.b].y != 0) continue;
        if (curve.line_class != LineClass::contour) continue;
        EXPECT_EQ(curve.kind, ContourKind::other_object) << "the floor it stands on";
    }
}

/// Walls over the whole image and beyond that cross in the line x = z = 0.
scene::Mesh wall(float slope) {
    const scene::Mesh mesh =
        quad({-8, -8, -8 * slope}, {8, -8, 8 * slope}, {8, 8, 8 * slope}, {-8, 8, -8 * slope});
    return mesh;
}

TEST(Crossing, TwoWallsShowOneLineFromEitherSide) {
    const scene::Scene scene = scene_of({wall(0.125F), wall(-0.125F)});
    for (const double side : {1.0, -1.0}) {
        const Truth truth = trace(scene, view_from({0, 0, 6 * side}, {0, 0, 0}));
        EXPECT_EQ(lengths(truth).size(), 1U);
        EXPECT_NEAR(lengths(truth)[LineClass::intersection], kHeight_px, kPx);
        for (const Curve& curve : truth.curves) {
            EXPECT_NEAR(curve.begin.x_px, 320, 1e-9);
            EXPECT_NEAR(curve.end.x_px, 320, 1e-9);
            EXPECT_NEAR(curve.begin.w, 6, 1e-9);
            EXPECT_NEAR(curve.deviation_rad, 2 * std::atan(0.125), 1e-6);
        }
    }
}

TEST(Crossing, ThreeWallsThroughOneLineShowItOnce) {
    // Left of the line the second is in front, right of it the third; the first is nowhere.
    const scene::Scene scene = scene_of({wall(0.125F), wall(-0.125F), wall(0.5F)});
    const Truth truth = trace(scene, view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], kHeight_px, kPx);
    for (const Curve& curve : truth.curves) {
        EXPECT_GE(curve.face0, 2U);
        EXPECT_LT(curve.face0, 4U);
        EXPECT_GE(curve.face1, 4U);
    }
}

TEST(Crossing, WallsOfSkewSlopesThroughOneLineShowItOnce) {
    // The same turned about the line of sight, where no coordinate is a round number.
    scene::Scene scene = scene_of({wall(0.3F), wall(-0.7F), wall(0.1F), wall(-0.2F)});
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 0, 1));
    for (scene::Instance& instance : scene.instances)
        instance.world_from_object = turn;
    const Truth truth = trace(scene, view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], kHeight_px / std::cos(0.3), 0.1);
}

TEST(Crossing, LineAlongAMeshEdgeIsDrawnOnce) {
    // The first square's diagonal lies in the second, whose own diagonal crosses it.
    const scene::Mesh level = quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0});
    const scene::Mesh upright = quad({-1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, -1, 1});
    const scene::Scene scene = scene_of({level, upright});
    const scene::View view = view_from({2, -1, 6}, {0, 0, 0});
    const Truth truth = trace(scene, view);
    EXPECT_EQ(truth.counts.crossings, 0U);
    EXPECT_EQ(truth.counts.contacts, 2U) << "the diagonal in both halves of the upright square";
    const double expected = length_px(view, {-1, -1, 0}, {1, 1, 0});
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], expected, kPx);
    EXPECT_NEAR(seen_length(scene, truth, {-2, -2, 0}, {2, 2, 0}), expected, kPx);
    for (const Curve& curve : truth.curves) {
        if (curve.line_class != LineClass::intersection) continue;
        EXPECT_NEAR(curve.deviation_rad, std::numbers::pi / 2, 1e-6) << "of the two squares";
    }
}

TEST(Crossing, LineAlongMeshEdgesOfBothIsDrawnOnce) {
    // Two crossing walls, each cut along the common line, at other heights so that nothing welds.
    scene::Mesh a, b;
    add_quad(a, {-1, -1, -1}, {0, -1, 0}, {0, 1, 0}, {-1, 1, -1});
    add_quad(a, {0, -1, 0}, {1, -1, 1}, {1, 1, 1}, {0, 1, 0});
    add_quad(b, {-1, -2, 1}, {0, -2, 0}, {0, 0.5F, 0}, {-1, 0.5F, 1});
    add_quad(b, {0, -2, 0}, {1, -2, -1}, {1, 0.5F, -1}, {0, 0.5F, 0});
    const Truth truth = trace(scene_of({a, b}), view_from(6));
    // Common to both from y = -1 to 0.5; 100 px a unit.
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], 150, kPx);
}

TEST(Crossing, TipOnAWallIsNoLine) {
    scene::Mesh level, tip;
    add_quad(level, {-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0});
    add_triangle(tip, {0.5F, 0.25F, 0}, {0.75F, 1, 1}, {0.25F, 1, 1});
    const Truth truth = trace(scene_of({level, tip}), view_from(6));
    EXPECT_EQ(lengths(truth).count(LineClass::intersection), 0U);
    EXPECT_EQ(truth.counts.crossings + truth.counts.contacts, 0U);
}

scene::Mesh ball(const glm::vec3& centre, float radius) {
    scene::Mesh mesh = catalogue::make_sphere(radius, 18, 12);
    for (glm::vec3& p : mesh.positions)
        p += centre;
    return mesh;
}

TEST(Crossing, OutOfSightNothingIsDrawn) {
    // Two balls that pierce each other inside a third.
    const scene::Scene scene =
        scene_of({ball({0, 0, 0}, 2), ball({-0.3F, 0.1F, 0}, 0.5F), ball({0.25F, 0, 0.1F}, 0.5F)});
    const Truth truth = trace(scene, view_from(8));
    EXPECT_GT(truth.counts.crossings, 20U);
    EXPECT_EQ(lengths(truth).count(LineClass::intersection), 0U);
}

TEST(Crossing, BallsThatPierceEachOtherShowTheirRing) {
    // Two balls of radius 1 at x = -0.6 and 0.6: the ring has radius 0.8 in the plane x = 0. From
    // (8, 0, 0) side on it is a circle that both balls' outlines hide; from the front a straight
    // line of 2 * 0.8, less at its ends where the ring turns away.
    const scene::Scene scene = scene_of({ball({-0.6F, 0, 0}, 1), ball({0.6F, 0, 0}, 1)});
    const Truth front = trace(scene, view_from(8));
    EXPECT_NEAR(lengths(front)[LineClass::intersection], 2 * 0.8 * 600 / 8, 6);
    const Truth side = trace(scene, view_from({8, 0, 0}, {0, 0, 0}));
    EXPECT_EQ(lengths(side).count(LineClass::intersection), 0U);
}

}  // namespace
}  // namespace ink::truth
