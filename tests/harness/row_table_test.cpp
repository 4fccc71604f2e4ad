#include "harness/rows/row_table.h"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/harness/random_rows.h"

namespace ink::harness {
namespace {

std::string lines_of(const std::vector<RowRecord>& rows) {
    std::string lines;
    for (const RowRecord& row : rows)
        lines += row_line(row.cell, row.study, row.row);
    return lines;
}

std::string error_of(const std::string& text) {
    return core::error_text([&] { return read_rows(core::split_csv(text, "rows.csv")); });
}

TEST(RowTable, HoldsWhatScriptsRelyOnOnceEachAndSaysWhatItMeans) {
    std::set<std::string> names;
    for (const core::Column& column : rows_table().info().columns) {
        EXPECT_TRUE(names.insert(column.name).second) << column.name << " is there twice";
        EXPECT_FALSE(column.doc.empty()) << column.name;
    }
    EXPECT_EQ(rows_table().info().columns[0].name, "cell");
    EXPECT_EQ(rows_table().info().columns[1].name, "study");
    std::istringstream names_of_columns(
        "method scene view split width height threads seed params status f_2px f_1px precision_2px "
        "recall_2px recall_contour recall_crease recall_seam mean_width_px ap prepare_ns draw_ns "
        "bytes_per_px image_hash truth_px k_crease "
        "skip_occlusion_culling skip_occlusion_culling_of commit dirty compiler flags cpu simd");
    for (std::string name; names_of_columns >> name;) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
    EXPECT_FALSE(names.contains("predicted_ns")) << "it follows from the whole run";
}

TEST(RowTable, ReadsAndWritesTheSameBytes) {
    RandomValues any(1);
    for (int trial = 0; trial < 20; ++trial) {
        const std::string lines = lines_of(random_rows(any, 20));
        const std::vector<RowRecord> rows = read_rows(file_of(rows_table(), lines));
        ASSERT_EQ(rows.size(), 20U);
        EXPECT_EQ(lines_of(rows), lines);
    }
}

TEST(RowTable, LeavesEmptyWhatWasNotMeasured) {
    Row row;
    row.method = "mote4";
    row.status = "failed: out of ink";
    row.k_2px = 7;
    std::istringstream names_of_columns(
        "f_2px k_2px n_pred truth_px draw_ns draw_n ap "
        "skip_occlusion_culling false_positives_crack k_random_2px recall_crease");
    for (std::string name; names_of_columns >> name;) {
        EXPECT_EQ(field(row, name), "") << name;
    }
    row.status = "ok";
    EXPECT_EQ(field(row, "k_2px"), "") << "it was not scored";
    row.f_2px = 0.1;
    EXPECT_EQ(field(row, "k_2px"), "7");
    EXPECT_EQ(field(row, "f_2px"), "0.1");
}

TEST(RowTable, WithoutTimesDiffersInColumnsOfTimesAlone) {
    RandomValues any(3);
    Row row = random_row(any);
    row.draw_ns = row.prepare_ns = row.pose_ns = 12;
    row.draw_ns_median = row.draw_ns_q75 = row.draw_ns_min = 12;
    row.draw_wall_ns = row.draw_cpu_ns = row.yardstick_ns = 12;
    row.time_doubt = "spread";
    row.draw_n = 3;
    const core::CsvTable timed = file_of(rows_table(), row_line(1, Study::compare, row));
    clear_times(row);
    const core::CsvTable cleared = file_of(rows_table(), row_line(1, Study::compare, row));
    for (std::size_t i = 0; i < timed.columns.size(); ++i) {
        const bool is_time = rows_table().info().columns[i].is_time;
        EXPECT_EQ(cleared.records[0][i], is_time ? "" : timed.records[0][i]) << timed.columns[i];
        if (!is_time) continue;
        EXPECT_NE(timed.records[0][i], "") << timed.columns[i];
    }
}

TEST(RowTable, KeepsWhereARowOfAnotherMachineComesFrom) {
    auto other = std::make_shared<core::Provenance>(core::provenance());
    other->cpu = "abacus, \"wooden\"";
    other->dirty = !other->dirty;
    other->libraries.back().second = "0";
    Row row;
    std::string lines = row_line(1, Study::compare, row);
    row.provenance = other;
    lines += row_line(2, Study::compare, row) + row_line(3, Study::tune, row);
    const std::vector<RowRecord> rows = read_rows(file_of(rows_table(), lines));
    EXPECT_EQ(rows[0].row.provenance, nullptr) << "this program on this machine";
    ASSERT_NE(rows[1].row.provenance, nullptr);
    EXPECT_EQ(rows[1].row.provenance->cpu, other->cpu);
    EXPECT_EQ(rows[1].row.provenance, rows[2].row.provenance) << "read once";
    EXPECT_EQ(lines_of(rows), lines);
}

TEST(RowTable, NamesLineColumnAndFieldOfWhatItCannotRead) {
    Row row;
    row.scene = "two\nlines";
    const std::string first = row_line(1, Study::compare, row);
    row.f_2px = 0.125;
    std::string second = row_line(2, Study::compare, row);
    EXPECT_EQ(error_of(core::heading(rows_table()) + first + second), "");
    std::string wrong = second;
    wrong.replace(wrong.find("0.125"), 5, "0.12x");
    EXPECT_EQ(error_of(core::heading(rows_table()) + first + wrong),
              "rows.csv, line 4: column f_2px holds '0.12x' (accepted: a number)");
    EXPECT_EQ(error_of(core::heading(rows_table()) + first + first),
              "rows.csv, line 4: column cell holds '1' (accepted: every cell once)");
    wrong = second;
    wrong.replace(wrong.find("above_crease"), 5, "about");
    EXPECT_THAT(
        error_of(core::heading(rows_table()) + wrong),
        testing::HasSubstr("line 2: column intersections holds 'about_crease' (accepted: "));
    EXPECT_EQ(error_of(core::heading(rows_table()) + second.substr(0, second.size() - 1)),
              "rows.csv, line 2: the file ends within a record (accepted: a file whose every line "
              "is ended)");
    EXPECT_THAT(error_of("cell,study,way\n"),
                testing::HasSubstr("rows.csv, line 1: column 3 is 'way' (accepted: 'axis'"));
    EXPECT_THAT(error_of(""), testing::HasSubstr("column 1 is missing"));
}

TEST(RowIndex, FindsRowsByTheirCell) {
    const std::vector<RowRecord> rows = {{3, Study::compare, {}}, {8, Study::motion, {}}};
    const RowIndex index(rows);
    EXPECT_EQ(index.find(8), &rows[1]);
    EXPECT_EQ(index.find(4), nullptr);
}

}  // namespace
}  // namespace ink::harness
