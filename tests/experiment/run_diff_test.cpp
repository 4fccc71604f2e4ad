#include "experiment/diff/run_diff.h"

#include <gmock/gmock.h>

#include <memory>

#include "core/error.h"

namespace ink::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Where a row was made: on the processor called `cpu`.
std::shared_ptr<const core::Provenance> made_on(const std::string& cpu) {
    core::Provenance provenance;
    provenance.cpu = cpu;
    return std::make_shared<core::Provenance>(provenance);
}

/// `k` of 100 true pixels found with 100 drawn.
harness::Row row_of(const std::string& method, int scene, std::int64_t k) {
    harness::Row row;
    row.method = method;
    row.scene = std::to_string(scene);
    row.view = "front";
    row.params = "threshold=20;width=1";
    row.width = 96;
    row.height = 54;
    row.k_2px = k;
    row.n_pred = row.n_truth = row.truth_px = 100;
    row.f_2px = static_cast<double>(k) / 100;
    row.image_hash = method + row.scene + std::to_string(k);
    row.draw_ns_min = 1000;
    row.provenance = made_on("one");
    return row;
}

RunData run_of(std::vector<harness::Row> rows) {
    RunData run;
    run.record.asked = "seed = 1\n[methods.mote4]\nthreshold = \"20\"\n";
    run.tables.rows = std::move(rows);
    return run;
}

RunData twelve_scenes() {
    std::vector<harness::Row> rows;
    for (int scene = 0; scene < 12; ++scene) {
        rows.push_back(row_of("ids", scene, 80));
        rows.push_back(row_of("mote4", scene, 70 + scene));
    }
    return run_of(std::move(rows));
}

TEST(PairCells, PairsByMethodPlaceSizeThreadsAndParameters) {
    std::vector<harness::Row> a{row_of("ids", 1, 80), row_of("ids", 2, 80)};
    std::vector<harness::Row> b{row_of("ids", 2, 80), row_of("ids", 3, 80), row_of("ids", 1, 80)};
    b.back().width = 192;
    const CellPairs pairs = pair_cells(a, b);
    ASSERT_EQ(pairs.paired.size(), 1U);
    EXPECT_EQ(pairs.paired[0].a, &a[1]);
    EXPECT_EQ(pairs.paired[0].b, &b[0]);
    EXPECT_THAT(pairs.gone, ElementsAre(&a[0]));
    EXPECT_THAT(pairs.added, ElementsAre(&b[1], &b[2]));
}

TEST(PairCells, PairsAnotherSettingOnlyWhereThereIsNoChoice) {
    std::vector<harness::Row> a{row_of("ids", 1, 80), row_of("mote4", 1, 80)};
    std::vector<harness::Row> b{row_of("ids", 1, 80), row_of("ids", 1, 80), row_of("mote4", 1, 80)};
    b[0].params = "threshold=1";
    b[1].params = "threshold=2";
    b[2].params = "threshold=3";
    const CellPairs pairs = pair_cells(a, b);
    ASSERT_EQ(pairs.paired.size(), 1U);
    EXPECT_EQ(pairs.paired[0].b, &b[2]);
    EXPECT_EQ(pairs.gone.size(), 1U) << "ids has two candidates";
    EXPECT_EQ(pairs.added.size(), 2U);
}

TEST(ChangedParameters, NamesWhatDiffersAndNothingElse) {
    EXPECT_EQ(changed_parameters("a=1;b=2", "a=1;b=2"), "");
    EXPECT_EQ(changed_parameters("a=1;b=2", "b=3;a=1"), "b 2 -> 3");
    EXPECT_EQ(changed_parameters("a=1", "b=2"), "a 1 -> -, b - -> 2");
    EXPECT_EQ(changed_parameters("", ""), "");
}

TEST(AskedChanges, NamesKeysWithBothValues) {
    const auto changes = asked_changes("seed = 1\n[m.a]\nt = '3'\nl = [1, 2]\n",
                                       "seed = 2\n[m.a]\nt = '3'\nl = [1, 2]\nu = true\n");
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].key, "m.a.u");
    EXPECT_EQ(changes[0].a, "-");
    EXPECT_EQ(changes[0].b, "true");
    EXPECT_EQ(changes[1].key, "seed");
    EXPECT_EQ(changes[1].a + changes[1].b, "12");
    EXPECT_THROW((void)asked_changes("seed = ", ""), core::Error);
}

TEST(DiffRuns, ARunAndItselfAreTheSame) {
    const RunData run = twelve_scenes();
    const RunDiff diff = diff_runs(run, run, 1);
    EXPECT_TRUE(diff.is_same());
    EXPECT_FALSE(diff.is_worse());
    EXPECT_EQ(diff.cells.paired.size(), 24U);
    ASSERT_EQ(diff.methods.size(), 2U);
    EXPECT_EQ(diff.methods[0].f.difference, 0.0);
    EXPECT_FALSE(diff.methods[0].soft_f.before) << "no run has ink";
    EXPECT_NEAR(diff.methods[0].time_ratio.value_or(0), 1, 1e-12);
}

TEST(DiffRuns, LessInkIsWorse) {
    RunData before = twelve_scenes();
    for (harness::Row& row : before.tables.rows)
        row.soft = {.matched_px = 90, .missing_px = 10};
    RunData after = before;
    for (harness::Row& row : after.tables.rows)
        if (row.method == "mote4") row.soft = {.matched_px = 80, .missing_px = 20};
    const RunDiff diff = diff_runs(before, after, 1);
    const MethodDiff& mote4 = diff.methods[0];
    EXPECT_EQ(mote4.method, "mote4");
    EXPECT_EQ(mote4.changed_scores, 12);
    EXPECT_EQ(mote4.f.difference, 0.0);
    EXPECT_NEAR(*mote4.soft_f.difference, 160.0 / 180 - 180.0 / 190, 1e-6);
    EXPECT_TRUE(mote4.is_worse());
}

TEST(DiffRuns, APlantedChangeNamesItsMethodFirstAndNoOther) {
    const RunData before = twelve_scenes();
    RunData after = twelve_scenes();
    after.record.asked = "seed = 1\n[methods.mote4]\nthreshold = \"25\"\n";
    for (harness::Row& row : after.tables.rows) {
        if (row.method != "mote4") continue;
        row.params = "threshold=25;width=1";
        row.k_2px -= 5;
        row.image_hash += "changed";
        row.draw_ns_min = 500;
    }
    const RunDiff diff = diff_runs(before, after, 1);
    ASSERT_EQ(diff.methods.size(), 2U);
    const MethodDiff& mote4 = diff.methods[0];
    EXPECT_EQ(mote4.method, "mote4");
    EXPECT_EQ(mote4.settings, "threshold 20 -> 25");
    EXPECT_EQ(mote4.changed_images, 12);
    EXPECT_EQ(mote4.changed_scores, 12);
    EXPECT_NEAR(mote4.f.difference.value_or(0), -0.05, 1e-12);
    ASSERT_TRUE(mote4.f.range);
    EXPECT_NEAR(mote4.f.range->high, -0.05, 1e-12) << "every scene fell by the same";
    EXPECT_NEAR(mote4.time_ratio.value_or(0), 0.5, 1e-12);
    EXPECT_TRUE(mote4.is_worse());
    EXPECT_TRUE(diff.is_worse());
    EXPECT_TRUE(diff.methods[1].is_same());
    ASSERT_EQ(diff.asked.size(), 1U);
    EXPECT_EQ(diff.asked[0].key, "methods.mote4.threshold");
    EXPECT_FALSE(diff_runs(after, before, 1).is_worse()) << "the other way round it is better";
}

TEST(DiffRuns, TimesCompareOnOneMachineAndBuildAlone) {
    const RunData before = twelve_scenes();
    RunData after = twelve_scenes();
    for (harness::Row& row : after.tables.rows)
        row.provenance = made_on("two");
    const RunDiff diff = diff_runs(before, after, 1);
    EXPECT_THAT(diff.times_obstacle, HasSubstr("processor differs: one, two"));
    EXPECT_FALSE(diff.methods[0].time_ratio);
    EXPECT_TRUE(diff.is_same()) << "another machine alone is no difference";
}

TEST(DiffRuns, ALostScoreAndACellThatIsGoneAreWorse) {
    const RunData before = twelve_scenes();
    RunData failed = twelve_scenes();
    failed.tables.rows[0].status = "too_large";
    failed.tables.rows[0].f_2px.reset();
    const RunDiff lost = diff_runs(before, failed, 1);
    EXPECT_EQ(lost.methods[0].method, "ids");
    EXPECT_EQ(lost.methods[0].lost, 1);
    EXPECT_TRUE(lost.is_worse());
    EXPECT_EQ(diff_runs(failed, before, 1).methods[0].won, 1);
    RunData shorter = twelve_scenes();
    shorter.tables.rows.pop_back();
    EXPECT_TRUE(diff_runs(before, shorter, 1).is_worse());
    EXPECT_FALSE(diff_runs(shorter, before, 1).is_worse());
}

TEST(DiffRuns, CountsViewsWithAnotherTruth) {
    const RunData before = twelve_scenes();
    RunData after = twelve_scenes();
    after.tables.rows[0].truth_px = after.tables.rows[1].truth_px = 99;
    EXPECT_EQ(diff_runs(before, after, 1).changed_truths, 1) << "both rows are of one view";
}

}  // namespace
}  // namespace ink::experiment
