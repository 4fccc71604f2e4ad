#include "lab/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ink::lab {
namespace {

using testing::ElementsAre;

/// A row with these counts at 2 px; as many pixels drawn as there are true ones.
Row counted_row(const std::string& method,
                const std::string& view,
                std::int64_t k,
                std::int64_t n) {
    Row row;
    row.method = method;
    row.scene = "cube";
    row.view = view;
    row.split = "train";
    row.k_2px = k;
    row.n_pred = row.n_truth = n;
    row.f_2px = static_cast<double>(k) / static_cast<double>(n);
    return row;
}

std::vector<Row> two_views() {
    Row small = counted_row("a", "front", 50, 100);
    small.k_1px = 40;
    small.n_pred_1px = 100;
    small.recall_by_class = {{"crease", 0.5}};
    small.truth_px_by_class = {{"crease", 100}};
    small.draw_ns = 2'000'000;
    small.bytes_per_px = 5;
    small.mean_width_px = 1;
    Row large = counted_row("a", "back", 300, 300);
    large.split = "heldout";
    large.k_1px = 200;
    large.n_pred_1px = 300;
    large.recall_by_class = {{"crease", 1.0}, {"seam", 0.25}};
    large.truth_px_by_class = {{"crease", 300}, {"seam", 4}};
    large.draw_ns = 4'000'000;
    large.bytes_per_px = 5;
    return {small, large};
}

TEST(Summarise, PoolsCountsAndTakesMeansApart) {
    const auto summaries = summarise(two_views());
    ASSERT_EQ(summaries.size(), 1U);
    const MethodSummary& s = summaries[0];
    EXPECT_EQ(s.views, 2);
    EXPECT_EQ(s.failed, 0);
    EXPECT_DOUBLE_EQ(*s.f_2px, 0.875);  // 2 * 350 / 800
    EXPECT_DOUBLE_EQ(*s.f_mean, 0.75);
    EXPECT_DOUBLE_EQ(*s.f_median, 0.75);
    EXPECT_DOUBLE_EQ(*s.f_1px, 0.6);  // 2 * 240 / 800
    EXPECT_DOUBLE_EQ(*s.f_train, 0.5);
    EXPECT_DOUBLE_EQ(*s.f_heldout, 1.0);
    EXPECT_DOUBLE_EQ(*s.precision, 0.875);
    EXPECT_DOUBLE_EQ(s.recall_by_class.at("crease"), 0.875);  // 350 of 400
    EXPECT_DOUBLE_EQ(s.recall_by_class.at("seam"), 0.25);
    EXPECT_EQ(s.recall_by_class.count("contour"), 0U);
    EXPECT_DOUBLE_EQ(*s.draw_ms, 3.0);
    EXPECT_EQ(s.bytes_per_px, 5);
}

TEST(Summarise, AnEmptyValueEntersNoMean) {
    EXPECT_DOUBLE_EQ(*summarise(two_views())[0].mean_width_px, 1.0);
}

TEST(Summarise, AFailedRowIsCountedAndNothingElse) {
    std::vector<Row> rows = two_views();
    rows[1].status = "failed: out of ink";
    const MethodSummary s = summarise(rows)[0];
    EXPECT_EQ(s.views, 1);
    EXPECT_EQ(s.failed, 1);
    EXPECT_DOUBLE_EQ(*s.f_2px, 0.5);
    EXPECT_FALSE(s.f_heldout);
    EXPECT_DOUBLE_EQ(*s.draw_ms, 2.0);
    EXPECT_FALSE(s.f_2px_range) << "one view has no spread";
}

TEST(Summarise, PutsBracketsLast) {
    const auto summaries = summarise({counted_row("none", "front", 0, 9),
                                      counted_row("b", "front", 1, 9),
                                      counted_row("a", "front", 1, 9)});
    ASSERT_EQ(summaries.size(), 3U);
    EXPECT_EQ(summaries[0].method, "b");
    EXPECT_EQ(summaries[1].method, "a");
    EXPECT_EQ(summaries[2].method, "none");
    EXPECT_TRUE(summaries[2].is_bracket);
}

TEST(Summarise, TheIntervalHoldsThePooledValueAndRepeats) {
    std::vector<Row> rows;
    for (int i = 0; i < 20; ++i)
        rows.push_back(counted_row("a", std::to_string(i), 50 + i, 100));
    const MethodSummary s = summarise(rows)[0];
    ASSERT_TRUE(s.f_2px_range);
    EXPECT_LT(s.f_2px_range->low, *s.f_2px);
    EXPECT_GT(s.f_2px_range->high, *s.f_2px);
    EXPECT_DOUBLE_EQ(s.f_2px_range->low, summarise(rows)[0].f_2px_range->low);
}

TEST(FLead, IsSureWhereEveryViewAgreesAndOnlyThere) {
    std::vector<Row> rows;
    for (int i = 0; i < 12; ++i) {
        const std::string view = std::to_string(i);
        rows.push_back(counted_row("even", view, 50 + i, 100));
        rows.push_back(counted_row("better", view, 52 + i, 100));
        rows.push_back(counted_row("moody", view, i % 2 == 0 ? 40 + i : 62 + i, 100));
    }
    const auto sure = f_lead(rows, "better", "even");
    ASSERT_TRUE(sure);
    EXPECT_NEAR(sure->low, 0.02, 1e-12) << "paired: every view differs by the same";
    EXPECT_NEAR(sure->high, 0.02, 1e-12);
    const auto unsure = f_lead(rows, "moody", "even");
    ASSERT_TRUE(unsure);
    EXPECT_LT(unsure->low, 0);
    EXPECT_GT(unsure->high, 0);
    EXPECT_FALSE(f_lead(rows, "better", "absent"));
}

TEST(ParetoFront, KeepsWhatNothingBeatsInBoth) {
    EXPECT_THAT(pareto_front({{5, 0.1}, {1, 0.5}, {2, 0.6}, {3, 0.3}, {3, 0.2}, {9, 0.1}}),
                ElementsAre(1U, 4U, 0U));
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Quantile, IsLinearBetweenNeighbours) {
    EXPECT_DOUBLE_EQ(*quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(*quantile({10, 20}, 0.25), 12.5);
    EXPECT_DOUBLE_EQ(*quantile({7}, 1), 7);
    EXPECT_FALSE(quantile({}, 0.5));
}

TEST(FindVerdict, NamesWinnerRunnerUpAndCheapestOfMethodsOnly) {
    Row fast = counted_row("fast", "front", 40, 100);
    fast.draw_ns = 1'000'000;
    Row good = counted_row("good", "front", 90, 100);
    good.draw_ns = 9'000'000;
    Row middling = counted_row("middling", "front", 60, 100);
    const auto summaries =
        summarise({fast, counted_row("oracle", "front", 100, 100), good, middling});
    const Verdict verdict = find_verdict(summaries);
    ASSERT_NE(verdict.best, nullptr);
    EXPECT_EQ(verdict.best->method, "good");
    EXPECT_EQ(verdict.runner_up->method, "middling");
    EXPECT_EQ(verdict.cheapest->method, "fast");
    EXPECT_EQ(find_verdict({}).best, nullptr);
}

}  // namespace
}  // namespace ink::lab
