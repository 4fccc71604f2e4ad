
#include <gmock/gmock.h>

#include "core/error.h"
#include "harness/rows/side_tables.h"
#include "tests/core/error_text.h"
#include "tests/harness/random_rows.h"

namespace ink::harness {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(SplitParams, ReadsWhatJoinParamsWrote) {
    EXPECT_THAT(split_params("a=x=y;b=2;c="),
                ElementsAre(Pair("a", "x=y"), Pair("b", "2"), Pair("c", "")));
    EXPECT_TRUE(split_params("").empty());
}

/// A row of a setting of `own` that says what sweep.csv can hold.
Row random_setting(RandomValues& any, const Row& own, const std::string& params) {
    Row row;
    row.method = own.method;
    row.scene = own.scene;
    row.params = params;
    if (any.coin()) row.status = "failed: " + any.text();
    Row scores;
    fill_random_scores(any, scores);
    if (row.is_ok() && any.coin()) {
        row.f_2px = scores.f_2px;
        row.precision_2px = scores.precision_2px;
        row.k_2px = scores.k_2px;
        row.n_pred = scores.n_pred;
        row.n_truth = scores.n_truth;
        row.false_negatives = scores.false_negatives;
        row.soft = scores.soft;
    }
    fill_random_times(any, row);
    row.image_hash = any.text();
    if (any.coin()) {
        row.cost = random_cost(any);
    }
    return row;
}

TEST(SweepTable, ReadsAndWritesTheSameBytes) {
    RandomValues any(5);
    std::vector<RowRecord> rows(2);
    rows[0] = {4, Study::compare, random_row(any)};
    rows[1] = {9, Study::compare, random_row(any)};
    for (RowRecord& of : rows)
        of.row.cell = of.cell;
    rows[0].row.params = "a=1;b=x;c=3";
    rows[1].row.params = "b=y;d=0.5";
    for (int trial = 0; trial < 50; ++trial) {
        const SweepColumns swept{{"a", "b"}, trial % 2 == 1};
        const Row first = random_setting(any, rows[0].row, "a=2;b=x, y;c=3");
        const Row second = random_setting(any, rows[1].row, "b=z;d=0.5");
        const std::string lines =
            sweep_line(4, 1, swept, first) + sweep_line(9, trial + 1, swept, second);
        const core::CsvTable csv = file_of(sweep_table(swept), lines);
        EXPECT_EQ(sweep_columns(csv).parameters, swept.parameters);
        const std::vector<Row> read = read_sweep(csv, RowIndex(rows));
        ASSERT_EQ(read.size(), 2U);
        EXPECT_EQ(read[0].params, first.params) << "its own c, the setting's a and b";
        EXPECT_EQ(read[1].params, second.params) << "it has no a";
        EXPECT_EQ(read[0].scene, rows[0].row.scene);
        EXPECT_EQ(read[0].triangles, rows[0].row.triangles);
        EXPECT_EQ(read[1].setting, trial + 1);
        EXPECT_EQ(read[0].soft.has_value(), swept.has_ink && first.soft);
        EXPECT_EQ(sweep_line(4, 1, swept, read[0]) +
                      sweep_line(read[1].cell, read[1].setting, swept, read[1]),
                  lines);
    }
}

TEST(SweepTable, RefusesUnknownCellsAndParametersCalledAsColumns) {
    const std::vector<RowRecord> rows = {{4, Study::compare, {}}};
    const core::CsvTable csv = file_of(sweep_table({{"a"}}), sweep_line(5, 1, {{"a"}}, Row()));
    EXPECT_EQ(
        core::error_text([&] { return read_sweep(csv, RowIndex(rows)); }),
        "sweep.csv, line 2: column cell holds '5' (accepted: the number of a cell of rows.csv)");
    EXPECT_THROW((void)sweep_table({{"n_pred"}}), core::Error);
    core::CsvTable short_one = csv;
    short_one.columns.pop_back();
    EXPECT_THROW((void)read_sweep(short_one, RowIndex(rows)), core::Error);
}

TEST(CostTable, GoesBackIntoTheRowsAsItWas) {
    RandomValues any(6);
    std::vector<RowRecord> rows = random_rows(any, 20);
    std::string lines;
    for (RowRecord& row : rows) {
        if (any.coin()) continue;
        row.row.cost = random_cost(any);
        lines += cost_line(row.cell, row.row);
    }
    std::vector<RowRecord> joined = rows;
    for (RowRecord& row : joined) {
        row.row.cost.reset();
    }
    join_costs(file_of(cost_table(), lines), joined);
    std::string again;
    for (const RowRecord& row : joined)
        again += cost_line(row.cell, row.row);
    EXPECT_EQ(again, lines);
    EXPECT_EQ(cost_line(1, Row()), "") << "a baseline has no cost";
    EXPECT_THROW(join_costs(file_of(cost_table(), lines), joined), core::Error) << "twice";
}

}  // namespace
}  // namespace ink::harness
