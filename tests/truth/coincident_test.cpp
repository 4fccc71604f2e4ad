#include <algorithm>

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

constexpr double kPx = 0.01;

/// Two upright tiles in one plane; from 6 away a unit is 100 px. They overlap in a unit square.
scene::Mesh large_tile() {
    return quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
}
scene::Mesh small_tile() {
    return quad({0, -0.5F, 0}, {2, -0.5F, 0}, {2, 0.5F, 0}, {0, 0.5F, 0});
}

TEST(Coincident, TheFirstObjectCoversTheSecond) {
    // Of the small tile its outer half is seen: three sides of it, and of the large one's right
    // side the middle is a seam.
    const Truth truth = trace(scene_of({large_tile(), small_tile()}), view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::boundary], 700 + 300, kPx);
    EXPECT_NEAR(lengths(truth)[LineClass::seam], 100, kPx);
    EXPECT_EQ(lengths(truth).size(), 2U);
    EXPECT_LT(truth.layers.triangle.at(370, 240), 2U);
    EXPECT_GE(truth.layers.triangle.at(470, 240), 2U);
    EXPECT_GT(sampled_f(truth), 0.99);
}

TEST(Coincident, InTheOtherOrderItLiesOnTop) {
    // All of the small tile is seen, half of its outline on the large one.
    const scene::Scene scene = scene_of({small_tile(), large_tile()});
    const Truth truth = trace(scene, view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::boundary], 700 + 300, kPx);
    EXPECT_NEAR(lengths(truth)[LineClass::seam], 300, kPx);
    EXPECT_EQ(lengths(truth).size(), 2U);
    for (int y = 195; y < 285; ++y) {
        for (int x = 325; x < 415; ++x)
            ASSERT_LT(truth.layers.triangle.at(x, y), 2U) << x << " " << y;
    }
    EXPECT_GT(sampled_f(truth), 0.99);
}

TEST(Coincident, OfOneObjectTheyAreOneSurface) {
    for (const auto& mesh :
         {joined({large_tile(), small_tile()}), joined({small_tile(), large_tile()})}) {
        const Truth truth = trace(scene_of({mesh}), view_from(6));
        EXPECT_NEAR(lengths(truth)[LineClass::boundary], 1000, kPx);
        EXPECT_EQ(lengths(truth).size(), 1U);
        EXPECT_GT(sampled_f(truth), 0.99);
    }
}

TEST(Coincident, FromBehindItIsTheSame) {
    const Truth truth =
        trace(scene_of({large_tile(), small_tile()}), view_from({0.1, 0.2, -6}, {0, 0, 0}));
    EXPECT_GT(lengths(truth)[LineClass::seam], 90);
    EXPECT_LT(lengths(truth)[LineClass::seam], 110);
    EXPECT_EQ(lengths(truth).size(), 2U);
}

TEST(Coincident, CutByAThirdTheyShowItOnce) {
    // A wall through both: where both are, only its crossing with the first is seen.
    const scene::Mesh wall = quad({-1.5F, 0, 1}, {1.5F, 0, 1}, {1.5F, 0, -1}, {-1.5F, 0, -1});
    const Truth truth =
        trace(scene_of({large_tile(), small_tile(), wall}), view_from({0, 3, 6}, {}));
    const auto expected = project({-1, 0, 0}, 6), end = project({1.5, 0, 0}, 6);
    // From (0, 3, 6) the points (x, 0, 0) are sqrt(45) away and stand across the line of sight.
    const double scale = 6 / std::sqrt(45.0);
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], (end.x - expected.x) * scale, kPx);
}

TEST(Coincident, OfAFloorAndABoxAtItThatWithTheLowerFacesIsSeen) {
    const scene::Mesh floor = quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
    // Stands on it, seen from below; and sunk so that its top lies in the floor's plane.
    for (const bool is_sunk : {false, true}) {
        const scene::Mesh body =
            is_sunk ? box({-1, -1, -1}, {1, 0, 1}) : box({-1, 0, -1}, {1, 1, 1});
        const scene::View view = view_from({0.5, is_sunk ? 8 : -8, 1}, {0, 0, 0});
        auto by_floor = lengths(trace(scene_of({floor, body}), view));
        EXPECT_EQ(by_floor.size(), 1U) << "its rim";
        EXPECT_EQ(by_floor.count(LineClass::boundary), 1U);
        auto by_body = lengths(trace(scene_of({body, floor}), view));
        EXPECT_EQ(by_body.size(), 2U);
        // A square of side 2 in one of side 4, seen under the same slant.
        EXPECT_NEAR(by_body[LineClass::seam], by_body[LineClass::boundary] / 2, 4);
        EXPECT_GT(by_body[LineClass::seam], 500);
    }
}

TEST(Coincident, BoxesOfOtherLengthsThatAbutWithLevelTopsHaveASeam) {
    // As if they shared vertices, though the second is longer on both sides.
    const scene::Scene scene =
        scene_of({box({-1, 0, -0.5F}, {0, 1, 0.5F}), box({0, 0, -1}, {1, 1, 1})});
    const Truth truth = trace(scene, view_from({-2, 6, 0.1}, {0, 0.5, 0}));
    const scene::Topology topology = scene::weld(scene);
    std::vector<LineClass> on_joint;
    double seam = 0;
    for (const Curve& curve : truth.curves) {
        if (curve.edge == kNoEdge) continue;
        const scene::Edge& edge = topology.edges[curve.edge];
        const glm::dvec3 &a = topology.p_world[edge.a], &b = topology.p_world[edge.b];
        if (a.x != 0 || b.x != 0 || a.y != 1 || b.y != 1) continue;
        if (curve.line_class == LineClass::seam) seam += length_px(curve);
        on_joint.push_back(curve.line_class);
    }
    EXPECT_GT(seam, 0);
    // What the longer box has beyond the shorter one's ends is its own crease or contour.
    EXPECT_TRUE(std::any_of(on_joint.begin(), on_joint.end(), [](LineClass c) {
        return c == LineClass::crease || c == LineClass::contour;
    }));
    EXPECT_GT(sampled_f(truth), 0.98);
}

}  // namespace
}  // namespace ink::truth
