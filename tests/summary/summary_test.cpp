#include "summary/summary.h"

#include <gmock/gmock.h>

namespace ink::summary {
namespace {

/// A row with these counts at 2 px; as many pixels drawn as there are true ones.
harness::Row counted_row(const std::string& method,
                         const std::string& view,
                         std::int64_t k,
                         std::int64_t n) {
    harness::Row row;
    row.method = method;
    row.scene = "cube";
    row.view = view;
    row.split = "train";
    row.k_2px = k;
    row.n_pred = row.n_truth = n;
    row.f_2px = static_cast<double>(k) / static_cast<double>(n);
    return row;
}

/// A scene of one view: `f` of `n` true pixels found, as many drawn.
harness::Row scene_row(const std::string& scene, std::int64_t k, std::int64_t n) {
    harness::Row row = counted_row("a", "front", k, n);
    row.scene = scene;
    return row;
}

std::vector<harness::Row> two_views() {
    harness::Row small = counted_row("a", "front", 50, 100);
    small.k_1px = 40;
    small.n_pred_1px = 100;
    small.by_class = {{"crease", {50, 100, 100}}};
    small.draw_ns = 2'000'000;
    small.bytes_per_px = 5;
    harness::Row large = counted_row("a", "back", 300, 300);
    large.split = "heldout";
    large.k_1px = 200;
    large.n_pred_1px = 300;
    large.by_class = {{"crease", {300, 300, 300}}, {"seam", {1, 4, 4}}};
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
    EXPECT_DOUBLE_EQ(*s.f.all, 0.875);  // 2 * 350 / 800
    EXPECT_DOUBLE_EQ(*s.f.macro, 0.875) << "one scene";
    EXPECT_DOUBLE_EQ(*s.f_1px, 0.6);  // 2 * 240 / 800
    EXPECT_DOUBLE_EQ(*s.f.train, 0.5);
    EXPECT_DOUBLE_EQ(*s.f.heldout, 1.0);
    EXPECT_FALSE(s.f.real) << "no row is of a model";
    EXPECT_DOUBLE_EQ(*s.precision, 0.875);
    EXPECT_DOUBLE_EQ(s.recall_by_class.at("crease"), 0.875);  // 350 of 400
    EXPECT_DOUBLE_EQ(s.recall_by_class.at("seam"), 0.25);
    EXPECT_EQ(s.recall_by_class.count("contour"), 0U);
    EXPECT_DOUBLE_EQ(*s.draw_ms, 3.0);
    EXPECT_EQ(s.bytes_per_px, 5);
}

TEST(Summarise, AFailedRowIsCountedAndNothingElse) {
    std::vector<harness::Row> rows = two_views();
    rows[1].status = "failed: out of ink";
    const MethodSummary s = summarise(rows)[0];
    EXPECT_EQ(s.views, 1);
    EXPECT_EQ(s.failed, 1);
    EXPECT_DOUBLE_EQ(*s.f.all, 0.5);
    EXPECT_FALSE(s.f.heldout);
    EXPECT_DOUBLE_EQ(*s.draw_ms, 2.0);
    EXPECT_FALSE(s.f.range) << "one view has no spread";
}

TEST(Summarise, PoolsTheInkOfViewsThatHaveIt) {
    std::vector<harness::Row> rows = two_views();
    rows[0].soft = {1.5, 20, 0, 10, 0};  // 20 of 30 px^2
    EXPECT_FALSE(summarise(rows)[0].soft_f.all) << "one view has none";
    rows[1].soft = {1.5, 60, 0, 0, 10};
    const MethodSummary s = summarise(rows)[0];
    EXPECT_DOUBLE_EQ(*s.soft_f.all, 160.0 / 180);
    EXPECT_DOUBLE_EQ(*s.soft_f.train, 0.8);
    EXPECT_EQ(&s.judged(), &s.soft_f);
    EXPECT_DOUBLE_EQ(*s.f.all, 0.875);
}

TEST(Summarise, PutsBaselinesLast) {
    const auto summaries = summarise({counted_row("none", "front", 0, 9),
                                      counted_row("b", "front", 1, 9),
                                      counted_row("a", "front", 1, 9)});
    ASSERT_EQ(summaries.size(), 3U);
    EXPECT_EQ(summaries[0].method, "b");
    EXPECT_EQ(summaries[1].method, "a");
    EXPECT_EQ(summaries[2].method, "none");
    EXPECT_TRUE(summaries[2].is_baseline);
}

TEST(Summarise, TheIntervalHoldsThePooledValueAndRepeats) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 20; ++i)
        rows.push_back(scene_row(std::to_string(i), 50 + i, 100));
    const MethodSummary s = summarise(rows)[0];
    ASSERT_TRUE(s.f.range);
    EXPECT_LT(s.f.range->low, *s.f.all);
    EXPECT_GT(s.f.range->high, *s.f.all);
    EXPECT_DOUBLE_EQ(s.f.range->low, summarise(rows)[0].f.range->low);
}

TEST(Summarise, MacroCountsScenesAlikeAndMicroPixels) {
    // A scene of 900 true pixels at F .9, in two views, and one of 100 at F .5.
    const auto s = summarise({scene_row("large", 360, 400),
                              scene_row("large", 450, 500),
                              scene_row("small", 50, 100)})[0];
    EXPECT_EQ(s.scenes, 2);
    EXPECT_DOUBLE_EQ(*s.f.all, 0.86);   // 2 * 860 / 2000
    EXPECT_DOUBLE_EQ(*s.f.macro, 0.7);  // (.9 + .5) / 2
}

TEST(AddCurves, GivesEachSummaryItsMethodsCurve) {
    auto summaries = summarise({counted_row("b", "front", 1, 9), counted_row("a", "front", 1, 9)});
    statistics::CellCurve curve{"a", {}};
    curve.counts.fill({5, 10, 10});
    add_curves({curve}, summaries);
    EXPECT_FALSE(summaries[0].ap);
    EXPECT_EQ(summaries[1].ap, 0.25);  // precision .5 up to recall .5
}

TEST(Summarise, NamesTheSceneWithMostOfTheError) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 6; ++i)
        rows.push_back(scene_row(std::to_string(i), i == 4 ? 60 : 98, 100));
    const MethodSummary s = summarise(rows)[0];
    EXPECT_EQ(s.f.error_scene, "4");
    EXPECT_DOUBLE_EQ(*s.f.error_scene_share, 0.8);  // 40 of 50
    EXPECT_TRUE(is_error_in_one_scene(s));
    rows.pop_back();
    EXPECT_FALSE(is_error_in_one_scene(summarise(rows)[0])) << "of five scenes";
    EXPECT_EQ(summarise({scene_row("fine", 9, 9)})[0].f.error_scene, "");
}

}  // namespace
}  // namespace ink::summary
