// Tables of the studies: what a line says of its cell.

#include <gmock/gmock.h>

#include <numbers>

#include "studies/motion_table.h"
#include "studies/roll_table.h"
#include "studies/scaling_table.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

TEST(RollTable, ALineHasAPredictionWhereTheMethodDeclaresACode) {
    const double degree = std::numbers::pi / 180;
    RollCurve curve{.method = "mote4", .params = "", .crease = 2};
    curve.samples = {{2 * degree, 8, 6, 0, false}, {359 * degree, 4, 0, -1.5, true}};
    EXPECT_EQ(roll_lines(3, curve), "3,2,2,8,6,,\n3,2,359,4,0,,\n");
    curve.is_predicted = true;
    EXPECT_EQ(roll_lines(3, curve), "3,2,2,8,6,0,false\n3,2,359,4,0,-1.5,true\n");
}

TEST(RollTable, TurnsTheShortWayFromPredictionToMeasurement) {
    const double degree = std::numbers::pi / 180;
    RollCurve curve{.method = "mote4", .params = "", .is_predicted = true};
    curve.vanishing = {{359 * degree, 2 * degree, 0.25}, {10 * degree, std::nullopt, std::nullopt}};
    EXPECT_EQ(vanishing_lines(7, curve), "7,0,359,2,3,0.25\n7,0,10,,,\n");
}

TEST(ScalingTable, NamesThePlaceByAxisAndValue) {
    const ScalingPoint point{
        .axis = ScalingAxis::pixels, .method = "mote4", .params = "", .x = 921600};
    EXPECT_EQ(scaling_row(point).view, "pixels=921600");
    EXPECT_EQ(scaling_line(2, point), "2,pixels,921600,0,\n") << "nothing timed, no noise";
    EXPECT_FALSE(scaling_row(point).draw_ns_min);
}

MotionRow hand_made_motion() {
    MotionRow row{.scene = "torus", .path = "orbit", .method = "mote4", .params = "k=1"};
    row.width_px = 640;
    row.height_px = 360;
    row.frames = 10;
    row.step_px = 0.25;
    row.flicker = {.appeared = 30, .disappeared = 20, .excused = 7, .n_counted = 10'000};
    row.pops = {.pops = 2, .runs = 5, .steps = 60};
    row.lives = {4, 0, 1, 1};
    row.lives_cut = 2;
    row.images_hash = "abc";
    return row;
}

TEST(MotionTable, IsEmptyBehindTheSequenceWhereACellFailed) {
    MotionRow row = hand_made_motion();
    EXPECT_EQ(motion_line(4, row), "4,10,60,0.25,0.005,30,20,7,10000,2,2,5,60,6,2,1\n");
    EXPECT_EQ(life_lines(4, row), "4,1,4\n4,3,1\n4,4,1\n");
    row.status = "failed";
    EXPECT_EQ(motion_line(4, row), "4,10,60,0.25,,,,,,,,,,,,\n");
}

TEST(MotionFaults, NameATruthThatIsNotPerfect) {
    MotionRow row = hand_made_motion();
    EXPECT_TRUE(motion_faults({row}).empty()) << "methods may be as bad as they are";
    row.method = "oracle";
    EXPECT_EQ(motion_faults({row}).size(), 1U);
    row.lives.clear();
    row.pops.pops = 0;
    EXPECT_THAT(motion_faults({row}).front(), HasSubstr("50 px of flicker"));
    row.flicker = {.excused = 9, .n_counted = 100};
    EXPECT_TRUE(motion_faults({row}).empty());
}

}  // namespace
}  // namespace ink::studies
