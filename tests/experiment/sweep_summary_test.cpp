#include "experiment/summary/sweep_summary.h"

#include <gtest/gtest.h>

namespace ink::experiment {
namespace {

/// `k` of 100 true pixels found with 100 drawn, in `ms`.
harness::Row row_of(const std::string& method,
                    const std::string& params,
                    std::int64_t k,
                    double ms) {
    harness::Row row;
    row.method = method;
    row.params = params;
    row.scene = "cube";
    row.view = "front";
    row.k_2px = k;
    row.n_pred = row.n_truth = 100;
    row.f_2px = static_cast<double>(k) / 100;
    if (ms > 0) row.draw_ns = static_cast<std::int64_t>(ms * 1e6);
    return row;
}

harness::Row elsewhere(harness::Row row, const std::string& scene) {
    row.scene = scene;
    return row;
}

std::vector<harness::Row> small_rows() {
    return {row_of("a", "k=1;threshold=9", 80, 4),
            row_of("none", "", 0, 0),
            row_of("oracle", "", 100, 0),
            elsewhere(row_of("a", "k=1;threshold=9", 20, 9), "torus"),
            elsewhere(row_of("oracle", "", 100, 0), "torus")};
}

std::vector<harness::Row> small_sweep() {
    return {row_of("a", "k=1;threshold=9", 80, 4),
            row_of("a", "k=1;threshold=7", 70, 6),    // slower and worse than as it comes
            row_of("a", "k=3;threshold=9", 60, 1),    // fastest
            row_of("a", "k=5;threshold=30", 95, 20),  // best
            row_of("a", "k=6;threshold=9", 95, 25)};
}

TEST(SummariseSweep, NamesEachSettingByWhatItChanges) {
    const std::vector<MethodSweep> methods = summarise_sweep(small_rows(), small_sweep());
    ASSERT_EQ(methods.size(), 1U);
    const std::vector<SettingSummary>& settings = methods[0].settings;
    ASSERT_EQ(settings.size(), 5U);
    EXPECT_TRUE(settings[0].is_default());
    EXPECT_EQ(settings[1].difference, "threshold=7");
    EXPECT_EQ(settings[3].difference, "k=5, threshold=30");
    EXPECT_DOUBLE_EQ(settings[3].draw_ms, 20);
    EXPECT_NEAR(settings[3].error, 0.05, 1e-12);
}

TEST(SummariseSweep, PoolsASettingOverItsViews) {
    std::vector<harness::Row> sweep = small_sweep();
    sweep.push_back(elsewhere(row_of("a", "k=3;threshold=9", 40, 3), "torus"));
    const SettingSummary fast = summarise_sweep(small_rows(), sweep)[0].settings[2];
    EXPECT_NEAR(fast.error, 0.5, 1e-12);  // 2 * (60 + 40) / 400
    EXPECT_DOUBLE_EQ(fast.draw_ms, 2);    // between 1 and 3
}

TEST(SummariseSweep, LeavesOutWhatFailedOrHasNoTime) {
    std::vector<harness::Row> sweep = small_sweep();
    sweep[3].status = "failed: out of ink";
    sweep[4].draw_ns.reset();
    EXPECT_EQ(summarise_sweep(small_rows(), sweep)[0].settings.size(), 3U);
    EXPECT_TRUE(summarise_sweep(small_rows(), {}).empty());
    EXPECT_TRUE(summarise_sweep({}, {}).empty());
}

}  // namespace
}  // namespace ink::experiment
