#include "studies/roll_prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/views/camera_path.h"

namespace ink::studies {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;

method::LinearCode code_of(double x, double y, double z) {
    method::LinearCode code;
    code.depth_weight = 63;
    code.normal_weight[0] = x;
    code.normal_weight[1] = y;
    code.normal_weight[2] = z;
    return code;
}

void expect_degrees(const std::vector<double>& angles_rad, const std::vector<double>& expected) {
    ASSERT_EQ(angles_rad.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(angles_rad[i] / kDegree_rad, expected[i], 1e-9);
}

TEST(RollPrediction, OneWeightVanishesWhereItsComponentIsTheSame) {
    // From (1, 0, 0) to (0, 1, 0): x is the same on both where the bisector stands along x or -x.
    const RollPrediction roll(code_of(100, 0, 0), {{1, 0, 0}, {0, 1, 0}});
    EXPECT_NEAR(roll.step(0), -50, 1e-12);
    EXPECT_NEAR(roll.step(90 * kDegree_rad), 50, 1e-12);
    expect_degrees(roll.vanishing_rad(), {45, 225});
}

TEST(RollPrediction, DepthsWeightPlaysNoPart) {
    method::LinearCode code = code_of(100, 0, 0);
    const CreaseNormals normals{{1, 0, 0}, {0, 1, 0}};
    const double step = RollPrediction(code, normals).step(1);
    code.depth_weight = 0;
    EXPECT_EQ(RollPrediction(code, normals).step(1), step);
}

TEST(RollPrediction, TheWeightOfZMovesTheAngles) {
    // 60 cos r - 30 = 0.
    const RollPrediction roll(code_of(120, 0, 60), {{0, 0, 1}, {1, 0, 0}});
    EXPECT_NEAR(roll.step(0), 30, 1e-12);
    expect_degrees(roll.vanishing_rad(), {60, 300});
}

TEST(RollPrediction, AWeightOfZAloneNeverOrAlwaysLosesIt) {
    const RollPrediction seen(code_of(0, 0, 60), {{0, 0, 1}, {1, 0, 0}});
    EXPECT_TRUE(seen.vanishing_rad().empty());
    EXPECT_NEAR(seen.step(2), -30, 1e-12);
    const RollPrediction unseen(code_of(0, 0, 60), {{0, 1, 0}, {1, 0, 0}});
    EXPECT_TRUE(unseen.vanishing_rad().empty());
    EXPECT_EQ(unseen.step(2), 0);
    // More weight on z than x and y can make up for.
    const RollPrediction steep(code_of(20, 0, 60), {{0, 0, 1}, {1, 0, 0}});
    EXPECT_TRUE(steep.vanishing_rad().empty());
}

TEST(RollPrediction, ACodeThatWrapsAlsoVanishesAtWholePeriods) {
    // 24 cos r is a multiple of 16 where cos r is 0 or 2/3 either way.
    method::LinearCode code = code_of(48, 0, 0);
    code.bits = 4;
    code.wraps = true;
    const RollPrediction roll(code, {{0, 0, 0}, {1, 0, 0}});
    const double acute = std::acos(2.0 / 3) / kDegree_rad;
    expect_degrees(roll.vanishing_rad(), {acute, 90, 180 - acute, 180 + acute, 270, 360 - acute});
    EXPECT_NEAR(roll.step(0), -8, 1e-12);  // or 8, or 24
}

TEST(RollPrediction, IsBlindWhereTwiceTheStepIsBelowTheThreshold) {
    // Two low bits are cleared, so 7 is 4 and 8 is 8.
    method::LinearCode code = code_of(2, 0, 0);
    const auto is_blind = [&](double step) {
        return RollPrediction(code, {{0, 0, 0}, {step, 0, 0}}).is_blind(0, 6);
    };
    EXPECT_TRUE(is_blind(0));
    EXPECT_TRUE(is_blind(3.7));
    EXPECT_FALSE(is_blind(3.8));
    EXPECT_TRUE(is_blind(-3.7));
    EXPECT_FALSE(is_blind(-3.8));
}

/// The plain reference: normals seen by the rolled camera itself.
TEST(RollPrediction, IsWhatTheRolledCameraSees) {
    const glm::dvec3 n0_world = glm::normalize(glm::dvec3(1, 2, 2));
    const glm::dvec3 n1_world = glm::normalize(glm::dvec3(-3, 1, 4));
    const method::LinearCode code = code_of(63, -21, 40);
    const scene::View start{scene::look_at({3, 2, 9}, glm::dvec3(0), {0, 1, 0}, 0.7), 64, 64};
    scene::CameraPath path = scene::make_path(scene::PathKind::roll, start, {{0, 0, 0}, 1}, 0);
    path.turn_rad = 0.3;
    const glm::dmat3& to_view = start.camera.view_from_world;
    const RollPrediction roll(code, {to_view * n0_world, to_view * n1_world});
    for (int frame = 0; frame < 22; ++frame) {
        const glm::dmat3 rolled = scene::frame_at(path, frame).view.camera.view_from_world;
        const glm::dvec3 change = rolled * n1_world - rolled * n0_world;
        const double expected = (63 * change.x - 21 * change.y + 40 * change.z) / 2;
        EXPECT_NEAR(roll.step(frame * 0.3), expected, 1e-9);
    }
}

}  // namespace
}  // namespace ink::studies
