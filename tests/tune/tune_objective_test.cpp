#include "tune/tune_objective.h"

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

/// Views of scenes without a kind.
TuneViews views_of(std::vector<std::size_t> scene_of_view, std::size_t scenes) {
    return {std::move(scene_of_view), std::vector<std::string>(scenes)};
}

TEST(TuneObjective, ScenesIsTheSquareOfTheMeanRoot) {
    EXPECT_EQ(error_of({}, {}, TuneObjective::scenes), 0);
    // Errors of .36 and .04, whatever their pixels: (.6 + .2) / 2 squared.
    EXPECT_NEAR(
        error_of(
            {{64, 100, 100}, {9600, 10000, 10000}}, views_of({0, 1}, 2), TuneObjective::scenes),
        0.16,
        1e-12);
}

TEST(TuneObjective, KindsCountAlikeWhateverTheirScenes) {
    // Two cars of .04, a tree of .36, which has two views of 64 of 100.
    const TuneViews views{{0, 1, 2, 2}, {"car", "car", "tree"}};
    const std::vector<score::CurveCount> counts = step({96, 96, 64, 64}).found.by_view;
    EXPECT_NEAR(error_of(counts, views, TuneObjective::kinds), 0.16, 1e-12);
    EXPECT_NEAR(error_of(counts, views, TuneObjective::worst), 0.36, 1e-12);
    EXPECT_NEAR(error_of(counts, views, TuneObjective::pooled), 0.20, 1e-12);
    EXPECT_NEAR(error_of(counts, views, TuneObjective::scenes), (1.0 / 3) * (1.0 / 3), 1e-12);
}

TEST(TuneObjective, EvenPrefersWhatGainsALittleEverywhereToWhatGainsMuchOnce) {
    TuneViews views{{0, 1, 2}, {"car", "scan", "tree"}};
    const std::vector<score::CurveCount> start = step({80, 50, 80}).found.by_view;
    // Before anything is gained it is the mean error of kinds.
    EXPECT_NEAR(error_of(start, views, TuneObjective::even), 0.30, 1e-12);
    views.at_start = start;
    EXPECT_NEAR(error_of(start, views, TuneObjective::even), 0.30, 1e-12);
    // Gains of .02 each count whole, of .30 only .03, which twice -.02 outweigh.
    const double even = error_of(step({82, 52, 82}).found.by_view, views, TuneObjective::even);
    const double once = error_of(step({78, 80, 78}).found.by_view, views, TuneObjective::even);
    EXPECT_NEAR(even, 0.28, 1e-12);
    EXPECT_NEAR(once, 0.30 + 0.01 / 3, 1e-12);
}

TEST(TuneObjective, ASceneWithoutAKindIsItsOwn) {
    const std::vector<score::CurveCount> counts = step({96, 64}).found.by_view;
    const TuneViews views = views_of({0, 1}, 2);
    EXPECT_EQ(error_of(counts, views, TuneObjective::kinds),
              error_of(counts, views, TuneObjective::scenes));
    EXPECT_NEAR(error_of(counts, views, TuneObjective::worst), 0.36, 1e-12);
}

TEST(LeaveOneOut, ScoresEachViewBySettingsThatAreBestOnTheOthers) {
    // The second step is best on views 1 and 2, thanks to view 0 the first is best on all.
    const std::vector<TuneStep> steps = {step({99, 50, 60}), step({20, 70, 80})};
    const auto left_out = leave_one_out(steps, views_of({0, 0, 0}, 1), TuneObjective::pooled);
    ASSERT_EQ(left_out.size(), 3U);
    EXPECT_EQ(left_out[0].k, 20) << "chosen by views 1 and 2";
    EXPECT_EQ(left_out[1].k, 50) << "chosen by views 0 and 2";
    EXPECT_EQ(left_out[2].k, 60) << "chosen by views 0 and 1";
}

TEST(LeaveOneOut, ScoresEachKindBySettingsThatAreBestOnTheOtherKinds) {
    // The first step is best on cars, the second on the tree: each is judged by the other's.
    const std::vector<TuneStep> steps = {step({90, 80, 30}), step({40, 50, 95})};
    const TuneViews views{{0, 1, 2}, {"car", "car", "tree"}};
    for (const TuneObjective objective : {TuneObjective::kinds, TuneObjective::worst}) {
        const auto left_out = leave_one_out(steps, views, objective);
        ASSERT_EQ(left_out.size(), 3U);
        EXPECT_EQ(left_out[0].k, 40) << "both cars go together";
        EXPECT_EQ(left_out[1].k, 50);
        EXPECT_EQ(left_out[2].k, 30);
    }
    EXPECT_TRUE(
        leave_one_out(steps, {{0, 1, 2}, {"car", "car", "car"}}, TuneObjective::kinds).empty());
}

TEST(LeaveOneOut, PassesOverWhatExceedsTheTimeBudget) {
    std::vector<TuneStep> steps = {step({90, 90}), step({60, 60})};
    steps[0].found.value = 3;
    for (const score::CurveCount& count :
         leave_one_out(steps, views_of({0, 0}, 1), TuneObjective::pooled)) {
        EXPECT_EQ(count.k, 60);
    }
}

TEST(LeaveOneOut, ASceneOfOneViewIsGoneWithIt) {
    // Without view 2, the only one of scene 1, both objectives see scene 0 alone.
    const std::vector<TuneStep> steps = {step({80, 80, 10}), step({70, 70, 90})};
    for (const TuneObjective objective : {TuneObjective::pooled, TuneObjective::scenes})
        EXPECT_EQ(leave_one_out(steps, views_of({0, 0, 1}, 2), objective)[2].k, 10);
}

TEST(LeaveOneOut, NeedsTwoViewsAndTheirCounts) {
    EXPECT_TRUE(leave_one_out({step({50})}, views_of({0}, 1), TuneObjective::pooled).empty());
    EXPECT_TRUE(leave_one_out({}, views_of({0, 0}, 1), TuneObjective::pooled).empty());
    EXPECT_TRUE(leave_one_out({step({})}, views_of({0, 0}, 1), TuneObjective::pooled).empty());
}

}  // namespace
}  // namespace ink::tune
