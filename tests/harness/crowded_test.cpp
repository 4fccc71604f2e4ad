#include "harness/truths/unscored_view.h"

#include <gmock/gmock.h>

#include "tests/harness/baselines.h"

namespace ink::harness {
namespace {

TEST(Crowded, AViewBeyondTheLimitSaysSoAndCountsAllBeside) {
    for (const Evaluation& evaluation : baselines_of("bush", {240, 135})) {
        const Row& row = evaluation.row;
        EXPECT_GT(row.crowded_share, kMostCrowded);
        EXPECT_THAT(row.status, testing::StartsWith("crowded: ")) << row.method;
        EXPECT_FALSE(row.is_scored());
        ASSERT_TRUE(row.with_crowded_2px.has_value()) << row.method;
        EXPECT_GT(row.with_crowded_2px->n_truth, 0);
        if (row.method == "none") {
            EXPECT_EQ(row.with_crowded_2px->f(), 0);
        }
        if (row.method == "oracle") {
            EXPECT_EQ(row.with_crowded_2px->f(), 1);
        }
        // Nothing that a reader could take into a mean.
        EXPECT_FALSE(row.f_2px || row.f_1px || row.recall_2px || row.all_intersections_2px);
        EXPECT_FALSE(row.random_baseline || !row.bins.empty());
        EXPECT_EQ(row.n_truth, 0);
    }
}

TEST(Crowded, WhereNothingIsBothCountsAreOne) {
    for (const Evaluation& evaluation : baselines_of("cube", {320, 180})) {
        const Row& row = evaluation.row;
        EXPECT_EQ(row.crowded_share, 0);
        EXPECT_EQ(row.status, "ok");
        const score::CurveCount counts{row.k_2px, row.n_pred, row.n_truth};
        EXPECT_EQ(row.with_crowded_2px, counts) << row.method;
    }
}

}  // namespace
}  // namespace ink::harness
