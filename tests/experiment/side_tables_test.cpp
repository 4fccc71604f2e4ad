// Tables of numbers beside rows.csv: what is written; of those that are read back, with the row of
// their cell.

#include <gmock/gmock.h>

#include "core/error.h"
#include "linear_code/cancellation.h"
#include "studies/axis_rows.h"
#include "tests/core/error_text.h"
#include "tests/harness/random_rows.h"

namespace ink::experiment {
namespace {

TEST(AxesTable, ALineSaysWhatAnAxisVaries) {
    studies::Axis axis;
    axis.name = "depth";
    axis.title = "format, encoding";
    axis.scale = studies::AxisScale::named;
    axis.value_names = {"z24", "z16"};
    axis.sentence = "Whatever.";
    EXPECT_EQ(studies::axes_table().line(axis),
              "depth,\"format, encoding\",,false,Whatever.,z24;z16\n");
}

TEST(FaultsTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(5);
    const std::vector<harness::RowRecord> rows = harness::random_rows(any, 40);
    std::string lines;
    for (const harness::RowRecord& row : rows) {
        lines += studies::faults_table().line(
            row.cell, {{}, {any.count(), any.count(), any.small(), any.small()}});
    }
    const auto read = studies::read_faults(harness::file_of(studies::faults_table(), lines),
                                           harness::RowIndex(rows));
    ASSERT_EQ(read.size(), rows.size());
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        again += studies::faults_table().line(rows[i].cell, read[i]);
        EXPECT_EQ(read[i].row.scene, rows[i].row.scene);
    }
    EXPECT_EQ(again, lines);
}

TEST(StudyTables, RefuseACellThatRowsDoNotHave) {
    const std::vector<harness::RowRecord> rows = {{1, harness::Study::compare, {}}};
    const harness::RowIndex index(rows);
    const auto is_refused = [](const std::string& error) {
        return error.find(
                   "line 2: column cell holds '9' (accepted: the number of a cell of "
                   "rows.csv)") != std::string::npos;
    };
    EXPECT_TRUE(is_refused(core::error_text([&] {
        (void)studies::read_faults(
            harness::file_of(studies::faults_table(), studies::faults_table().line(9, {})), index);
    })));
}

}  // namespace
}  // namespace ink::experiment
