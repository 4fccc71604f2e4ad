#include "tune/tune_log.h"

#include <gtest/gtest.h>

namespace ink::tune {
namespace {

/// A step whose views have these matched pixels, of 100 drawn and 100 true ones each.
TuneStep step(const std::vector<std::int64_t>& matched) {
    TuneStep made{"global", {}, {}};
    for (const std::int64_t k : matched)
        made.found.by_view.push_back({k, 100, 100});
    return made;
}

TEST(ScenesError, IsTheSquareOfTheMeanRoot) {
    EXPECT_EQ(scenes_error({}), 0);
    // Errors of .36 and .04, whatever their pixels: (.6 + .2) / 2 squared.
    EXPECT_NEAR(scenes_error({{64, 100, 100}, {9600, 10000, 10000}}), 0.16, 1e-12);
}

TEST(LeaveOneViewOut, ScoresEachViewBySettingsThatAreBestOnTheOthers) {
    // The second step is best on views 1 and 2, thanks to view 0 the first is best on all.
    const std::vector<TuneStep> steps = {step({99, 50, 60}), step({20, 70, 80})};
    const auto left_out = leave_one_view_out(steps, {0, 0, 0}, TuneObjective::error);
    ASSERT_EQ(left_out.size(), 3U);
    EXPECT_EQ(left_out[0].k, 20) << "chosen by views 1 and 2";
    EXPECT_EQ(left_out[1].k, 50) << "chosen by views 0 and 2";
    EXPECT_EQ(left_out[2].k, 60) << "chosen by views 0 and 1";
}

TEST(LeaveOneViewOut, PassesOverWhatExceedsTheTimeBudget) {
    std::vector<TuneStep> steps = {step({90, 90}), step({60, 60})};
    steps[0].found.value = 3;
    for (const score::CurveCount& count : leave_one_view_out(steps, {0, 0}, TuneObjective::error)) {
        EXPECT_EQ(count.k, 60);
    }
}

TEST(LeaveOneViewOut, ASceneOfOneViewIsGoneWithIt) {
    // Without view 2, the only one of scene 1, both objectives see scene 0 alone.
    const std::vector<TuneStep> steps = {step({80, 80, 10}), step({70, 70, 90})};
    for (const TuneObjective objective : {TuneObjective::error, TuneObjective::scenes})
        EXPECT_EQ(leave_one_view_out(steps, {0, 0, 1}, objective)[2].k, 10);
}

TEST(LeaveOneViewOut, NeedsTwoViewsAndTheirCounts) {
    EXPECT_TRUE(leave_one_view_out({step({50})}, {0}, TuneObjective::error).empty());
    EXPECT_TRUE(leave_one_view_out({}, {0, 0}, TuneObjective::error).empty());
    EXPECT_TRUE(leave_one_view_out({step({})}, {0, 0}, TuneObjective::ap).empty());
}

}  // namespace
}  // namespace ink::tune
