// Tables of the studies: what a line says of its cell.

#include <gmock/gmock.h>

#include "studies/motion_study.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

MotionRow hand_made_motion() {
    MotionRow row;
    row.method = "mote4";
    row.scene = "torus";
    row.frames = 10;
    row.step_px = 0.25;
    row.flicker = {.appeared = 30, .disappeared = 20, .excused = 7, .n_counted = 10'000};
    row.pops = {.pops = 2, .runs = 5, .steps = 60};
    row.lives = {4, 0, 1, 1};
    row.lives_cut = 2;
    return row;
}

TEST(MotionTable, IsEmptyBehindTheSequenceWhereACellFailed) {
    MotionRow row = hand_made_motion();
    EXPECT_EQ(motion_table().line(4, row), "4,10,60,0.25,0.005,30,20,7,10000,2,5,60,6,2\n");
    EXPECT_EQ(life_lines(4, row), "4,1,4\n4,3,1\n4,4,1\n");
    EXPECT_EQ(ink_motion_table().line(4, row), "4,,\n");
    row.ink = {.true_px = 8, .beyond_px = 2};
    EXPECT_EQ(ink_motion_table().line(4, row), "4,8,2\n");
    row.status = "failed";
    EXPECT_EQ(motion_table().line(4, row), "4,10,60,0.25,,,,,,,,,,\n");
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
