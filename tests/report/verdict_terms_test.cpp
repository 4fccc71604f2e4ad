#include "report/text/verdict_terms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text_table.h"
#include "tests/report/made_up_rows.h"

namespace ink::report {
namespace {

using testing::ElementsAre;

std::vector<experiment::MethodSummary> summaries_with_everything() {
    harness::Row row = made_up_row("fine", 0.9, 8);
    row.params = "max_threshold=3;threshold=24";
    row.threshold = 24;
    row.tolerance_sweep = {{700, 1000, 1000},
                           {800, 1000, 1000},
                           {900, 1000, 1000},
                           {950, 1000, 1000},
                           {960, 1000, 1000}};
    row.random_baseline = score::CurveCount{40, 1000, 1000};
    auto summaries = experiment::summarise({row});
    statistics::CellCurve curve{"fine", true, {}};
    curve.counts.fill({500, 1000, 1000});
    curve.counts[9].k = 910;  // threshold 10/100, on from an edge response of 26
    experiment::add_curves({curve}, summaries);
    return summaries;
}

TEST(StatisticsColumns, HaveTheRandomBaselineThresholdsAndTheToleranceSweep) {
    const auto summaries = summaries_with_everything();
    const core::Cells cells = cells_of(statistics_columns(summaries), summaries);
    EXPECT_THAT(cells[0],
                ElementsAre("random",
                            "threshold",
                            "best",
                            "ODS",
                            "OIS",
                            "AP",
                            "1 px",
                            "1.5 px",
                            "2 px",
                            "3 px",
                            "4 px"));
    EXPECT_THAT(cells[1],
                ElementsAre(".040",
                            "24",
                            "26",
                            ".910",
                            ".910",
                            ".828",  // precision and recall .91: .91 * .91
                            ".700",
                            ".800",
                            ".900",
                            ".950",
                            ".960"));
}

TEST(StatisticsColumns, AreLeftOutWhereThereIsNothing) {
    EXPECT_TRUE(statistics_columns(experiment::summarise({made_up_row("fine", 0.9, 8)})).empty());
}

TEST(FormatPairedDifference, HasTheIntervalIfThereIsOne) {
    EXPECT_EQ(experiment::format_paired_difference(
                  {"a", "b", 0.0123, statistics::Interval{-0.002, 0.021}}),
              "+.012 [-.002, +.021]");
    // With three digits nobody could tell on which side of 0 it ends.
    EXPECT_EQ(experiment::format_paired_difference(
                  {"a", "b", 0.0011, statistics::Interval{-0.0002, 0.0018}}),
              "+.0011 [-.0002, +.0018]");
    EXPECT_EQ(experiment::format_paired_difference({"a", "b", -0.5, std::nullopt}), "-.500");
}

TEST(PairedDifferenceCells, AreAMatrixWithAnEmptyDiagonal) {
    const core::Cells cells =
        paired_difference_cells({{"x", "y", 0.1, std::nullopt}, {"y", "x", -0.1, std::nullopt}});
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_THAT(cells[0], ElementsAre("F minus F of", "x", "y"));
    EXPECT_THAT(cells[1], ElementsAre("x", "", "+.100"));
    EXPECT_THAT(cells[2], ElementsAre("y", "-.100", ""));
    EXPECT_TRUE(paired_difference_cells({}).empty());
}

TEST(ThresholdLines, SayWhatTheBestAndTheShippedOneReach) {
    harness::Row row = made_up_row("fine", 0.9, 8);
    statistics::CellCurve curve{"fine", true, {}};
    curve.counts.fill({500, 1000, 1000});
    curve.counts[9].k = 910;
    EXPECT_EQ(
        threshold_lines({row}, {curve}),
        "fine: best threshold over these training scenes 26 (F .910 pooled); its own, 24, has F "
        ".900\n");
    curve.is_training = false;
    EXPECT_EQ(threshold_lines({row}, {curve}), "");
}

}  // namespace
}  // namespace ink::report
