// Tables of numbers beside rows.csv: what is written is read back, with the row of its cell.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "linear_code/bound_tables.h"
#include "linear_code/cancellation_table.h"
#include "studies/scaling_table.h"
#include "studies/skips_table.h"
#include "studies/stress_table.h"
#include "tests/harness/random_rows.h"

namespace ink::experiment {
namespace {

TEST(SkipsTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(4);
    std::vector<harness::RowRecord> rows;
    std::string lines;
    const studies::SkipStudyOptions options;
    for (std::int64_t cell = 1; cell <= 40; ++cell) {
        studies::SkipTime time;
        time.scene = any.text();
        if (any.coin()) time.skip = static_cast<raster::Skip>(any.below(raster::kSkipCount));
        time.method = any.text();
        time.params = any.text();
        time.arm = static_cast<studies::SkipArm>(any.below(3));
        for (const raster::SkipInfo& info : raster::skip_infos())
            time.allowed.set(info.skip, any.coin());
        time.triangles = any.small();
        time.draw_ns = any.maybe([&] { return any.count(); });
        time.draw_ns_min = any.maybe([&] { return any.count(); });
        time.draw_n = any.small();
        for (raster::SkipCount& count : time.counts)
            count = {static_cast<std::uint64_t>(any.small()), 1000};
        time.image_hash = any.text();
        if (any.coin()) time.status = "differs: " + any.text();
        rows.push_back({cell, harness::Study::skips, studies::skip_row(time, options)});
        lines += studies::skip_line(cell, time);
    }
    const std::vector<harness::RowRecord> of_file = harness::read_again(rows);
    const auto read = studies::read_skips(harness::file_of(studies::skips_table(), lines),
                                          harness::RowIndex(of_file));
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto cell = static_cast<std::int64_t>(i + 1);
        again += studies::skip_line(cell, read[i]);
        EXPECT_EQ(
            harness::row_line(cell, harness::Study::skips, studies::skip_row(read[i], options)),
            harness::row_line(cell, harness::Study::skips, rows[i].row));
    }
    EXPECT_EQ(again, lines);
}

TEST(StressTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(5);
    const std::vector<harness::RowRecord> rows = harness::random_rows(any, 40);
    std::string lines;
    for (const harness::RowRecord& row : rows) {
        studies::StressRow stress{any.text(), any.real(), any.text(), row.row};
        stress.counts = {any.count(), any.count(), any.small(), any.small()};
        lines += studies::stress_line(row.cell, stress);
    }
    const auto read = studies::read_stress(harness::file_of(studies::stress_table(), lines),
                                           harness::RowIndex(rows));
    ASSERT_EQ(read.size(), rows.size());
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        again += studies::stress_line(rows[i].cell, read[i]);
        EXPECT_EQ(read[i].row.scene, rows[i].row.scene);
    }
    EXPECT_EQ(again, lines);
}

TEST(CancellationTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(6);
    const std::vector<harness::RowRecord> rows = harness::random_rows(any, 10);
    std::string lines;
    std::vector<std::int64_t> cells;
    for (const harness::RowRecord& row : rows) {
        for (const truth::LineClass c : truth::kLineClasses) {
            linear_code::CancellationRow kind;
            kind.silent_deg = any.real();
            kind.kind.line_class = c;
            kind.kind.dihedral_low_deg = any.maybe([&] { return any.small(); });
            kind.count = {
                any.count(), any.count(), any.count(), any.count(), any.count(), any.count()};
            lines += linear_code::cancellation_line(row.cell, kind);
            cells.push_back(row.cell);
        }
    }
    const auto read = linear_code::read_cancellation(
        harness::file_of(linear_code::cancellation_table(), lines), harness::RowIndex(rows));
    ASSERT_EQ(read.size(), cells.size());
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i)
        again += linear_code::cancellation_line(cells[i], read[i]);
    EXPECT_EQ(again, lines);
    EXPECT_EQ(read.back().method, rows.back().row.method);
    EXPECT_EQ(read.back().view, rows.back().row.view);
}

TEST(BoundTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(7);
    const std::vector<harness::RowRecord> rows = harness::random_rows(any, 20);
    std::string lines;
    for (const harness::RowRecord& row : rows) {
        linear_code::BoundRow bound;
        bound.views = any.small();
        bound.measured = {any.small(), any.small(), any.small()};
        if (any.coin()) bound.modelled = {any.small(), any.small(), any.small()};
        bound.bound.f_upper = any.share();
        bound.bound.f_found = any.share();
        for (double& weight : bound.bound.weights)
            weight = any.real();
        bound.bound.count = {any.small(), any.small(), any.small()};
        bound.bound.boxes = any.count();
        lines += linear_code::bound_line(row.cell, bound);
    }
    const auto read = linear_code::read_bounds(harness::file_of(linear_code::bound_table(), lines),
                                               harness::RowIndex(rows));
    ASSERT_EQ(read.size(), rows.size());
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        again += linear_code::bound_line(rows[i].cell, read[i]);
        EXPECT_EQ(read[i].scene, rows[i].row.scene);
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
    EXPECT_TRUE(is_refused(harness::message_of([&] {
        (void)studies::read_stress(
            harness::file_of(studies::stress_table(), studies::stress_line(9, {})), index);
    })));
    EXPECT_TRUE(is_refused(harness::message_of([&] {
        (void)studies::read_skips(
            harness::file_of(studies::skips_table(), studies::skip_line(9, {})), index);
    })));
    EXPECT_TRUE(is_refused(harness::message_of([&] {
        (void)studies::read_scaling(
            harness::file_of(studies::scaling_table(), studies::scaling_line(9, {})), index);
    })));
    EXPECT_TRUE(is_refused(harness::message_of([&] {
        (void)linear_code::read_bounds(
            harness::file_of(linear_code::bound_table(), linear_code::bound_line(9, {})), index);
    })));
    linear_code::CancellationRow crease;
    crease.kind = {truth::LineClass::crease, 40};
    EXPECT_TRUE(is_refused(harness::message_of([&] {
        (void)linear_code::read_cancellation(
            harness::file_of(linear_code::cancellation_table(),
                             linear_code::cancellation_line(9, crease)),
            index);
    })));
}

}  // namespace
}  // namespace ink::experiment
