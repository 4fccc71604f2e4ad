// Tables of the studies: what is written of a record is read back, with the row of its cell.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "studies/motion_table.h"
#include "studies/roll_table.h"
#include "studies/scaling_table.h"
#include "tests/harness/random_rows.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

MotionRow random_motion(harness::RandomValues& any) {
    MotionRow row;
    row.scene = any.text();
    row.path = "orbit";
    row.method = any.text();
    row.params = any.text();
    row.width_px = any.small();
    row.height_px = any.small();
    row.threads = any.small();
    row.frames = any.small();
    row.frames_per_s = any.real();
    row.step_px = any.real();
    row.split = "train";
    row.triangles = any.small();
    if (any.coin()) {
        row.status = "failed: " + any.text();
        return row;
    }
    row.flicker = {any.small(), any.small(), any.small(), any.small()};
    row.pops = {any.small(), any.small(), any.small()};
    for (std::size_t n = any.below(5); n > 0; --n)
        row.lives.push_back(any.coin() ? 0 : any.small());
    if (!row.lives.empty()) row.lives.push_back(1 + any.small());
    row.lives_cut = any.small();
    row.images_hash = any.text();
    return row;
}

TEST(MotionTable, ReadsAndWritesTheSameBytesWithLivesAsLines) {
    harness::RandomValues any(1);
    std::vector<harness::RowRecord> rows;
    std::vector<MotionRow> written;
    std::string motion, lives;
    for (std::int64_t cell = 1; cell <= 40; ++cell) {
        written.push_back(random_motion(any));
        rows.push_back({cell, harness::Study::motion, motion_row(written.back())});
        motion += motion_line(cell, written.back());
        lives += life_lines(cell, written.back());
    }
    const std::vector<harness::RowRecord> of_file = harness::read_again(rows);
    const auto read = read_motion(harness::file_of(motion_table(), motion),
                                  harness::file_of(lives_table(), lives),
                                  harness::RowIndex(of_file));
    ASSERT_EQ(read.size(), written.size());
    std::string motion_again, lives_again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto cell = static_cast<std::int64_t>(i + 1);
        EXPECT_EQ(read[i].lives, written[i].lives);
        EXPECT_EQ(read[i].flicker, written[i].flicker);
        EXPECT_EQ(harness::row_line(cell, harness::Study::motion, motion_row(read[i])),
                  harness::row_line(cell, harness::Study::motion, rows[i].row));
        motion_again += motion_line(cell, read[i]);
        lives_again += life_lines(cell, read[i]);
    }
    EXPECT_EQ(motion_again, motion);
    EXPECT_EQ(lives_again, lives);
}

TEST(MotionTable, RefusesLivesThatNobodyLived) {
    const std::vector<harness::RowRecord> rows = {{1, harness::Study::motion, {}}};
    const harness::CsvTable motion = harness::file_of(motion_table(), motion_line(1, {}));
    const auto error = [&](const std::string& lives) {
        return harness::message_of([&] {
            (void)read_motion(
                motion, harness::file_of(lives_table(), lives), harness::RowIndex(rows));
        });
    };
    EXPECT_EQ(error("1,1,4\n1,3,2\n"), "");
    EXPECT_THAT(error("2,1,4\n"), HasSubstr("lives.csv, line 2: column cell holds '2'"));
    EXPECT_THAT(error("1,3,4\n1,3,4\n"), HasSubstr("line 3: column frames holds '3'"));
    EXPECT_THAT(error("1,0,4\n"), HasSubstr("column frames holds '0'"));
}

RollCurve random_curve(harness::RandomValues& any, int crease) {
    RollCurve curve{.method = any.text(), .params = any.text(), .crease = crease};
    curve.is_predicted = any.coin();
    const std::size_t count = 1 + any.below(30);
    for (std::size_t i = 0; i < count; ++i) {
        RollSample sample{
            .roll_rad = static_cast<double>(i) * 2 * std::numbers::pi / static_cast<double>(count),
            .length_px = std::abs(any.real()),
            .covered_px = any.real()};
        if (curve.is_predicted) sample.step = any.real();
        sample.is_blind = curve.is_predicted && any.coin();
        curve.samples.push_back(sample);
    }
    if (!curve.is_predicted) return curve;
    for (std::size_t n = any.below(4); n > 0; --n) {
        Vanishing at{.predicted_rad = any.share() * 6};
        at.measured_rad = any.maybe([&] { return any.share() * 6; });
        at.recall_there = any.maybe([&] { return any.share(); });
        curve.vanishing.push_back(at);
    }
    return curve;
}

TEST(RollTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(2);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<harness::RowRecord> rows;
        std::vector<std::int64_t> cells;
        std::string roll, vanishing;
        for (std::int64_t cell = 3; cell < 6; ++cell) {
            const std::string method = any.text(), params = any.text();
            for (int crease = 0; crease < 3; ++crease) {
                RollCurve curve = random_curve(any, crease);
                curve.method = method;
                curve.params = params;
                if (crease == 0) rows.push_back({cell, harness::Study::roll, roll_row(curve, {})});
                cells.push_back(cell);
                roll += roll_lines(cell, curve);
                vanishing += vanishing_lines(cell, curve);
            }
        }
        const std::vector<harness::RowRecord> of_file = harness::read_again(rows);
        const auto read = read_rolls(harness::file_of(roll_table(), roll),
                                     harness::file_of(vanishing_table(), vanishing),
                                     harness::RowIndex(of_file));
        ASSERT_EQ(read.size(), 9U);
        EXPECT_EQ(read[3].method, rows[1].row.method);
        std::string roll_again, vanishing_again;
        for (std::size_t i = 0; i < read.size(); ++i) {
            roll_again += roll_lines(cells[i], read[i]);
            vanishing_again += vanishing_lines(cells[i], read[i]);
        }
        EXPECT_EQ(roll_again, roll);
        EXPECT_EQ(vanishing_again, vanishing);
    }
}

TEST(RollTable, TurnsTheShortWayFromPredictionToMeasurement) {
    const double degree = std::numbers::pi / 180;
    RollCurve curve{.method = "mote4", .params = "", .is_predicted = true};
    curve.vanishing = {{359 * degree, 2 * degree, 0.25}, {10 * degree, std::nullopt, std::nullopt}};
    EXPECT_EQ(vanishing_lines(7, curve), "7,0,359,2,3,0.25\n7,0,10,,,\n");
}

TEST(ScalingTable, ReadsAndWritesTheSameBytes) {
    harness::RandomValues any(3);
    std::vector<harness::RowRecord> rows;
    std::string lines;
    for (std::int64_t cell = 1; cell <= 40; ++cell) {
        ScalingPoint point;
        point.axis = static_cast<ScalingAxis>(any.below(3));
        point.method = any.text();
        point.params = any.text();
        point.x = any.real();
        point.width_px = any.small();
        point.triangles = any.small();
        point.covered_share = any.share();
        point.draw_ns_min = any.small();
        point.draw_n = 1 + any.small();
        point.noise = any.share();
        if (any.coin()) clear_times(point);
        if (any.coin()) point.status = "failed: " + any.text();
        rows.push_back({cell, harness::Study::scaling, scaling_row(point)});
        lines += scaling_line(cell, point);
    }
    const std::vector<harness::RowRecord> of_file = harness::read_again(rows);
    const auto read =
        read_scaling(harness::file_of(scaling_table(), lines), harness::RowIndex(of_file));
    std::string again;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto cell = static_cast<std::int64_t>(i + 1);
        again += scaling_line(cell, read[i]);
        EXPECT_EQ(harness::row_line(cell, harness::Study::scaling, scaling_row(read[i])),
                  harness::row_line(cell, harness::Study::scaling, rows[i].row));
    }
    EXPECT_EQ(again, lines);
    EXPECT_THAT(harness::message_of([&] {
                    (void)read_scaling(harness::file_of(scaling_table(), "1,weight,1,1,0.1\n"),
                                       harness::RowIndex(rows));
                }),
                HasSubstr("column axis holds 'weight' (accepted: triangles, pixels, covered)"));
}

TEST(ScalingTable, NamesThePlaceByAxisAndValue) {
    const ScalingPoint point{
        .axis = ScalingAxis::pixels, .method = "mote4", .params = "", .x = 921600};
    EXPECT_EQ(scaling_row(point).view, "pixels=921600");
    EXPECT_EQ(scaling_line(2, point), "2,pixels,921600,0,\n") << "nothing timed, no noise";
    EXPECT_FALSE(scaling_row(point).draw_ns_min);
}

MotionRow hand_made_motion() {
    MotionRow row{.scene = "torus", .path = "orbit", .method = "mote4", .params = "k=1"};
    row.width_px = 640;
    row.height_px = 360;
    row.frames = 10;
    row.step_px = 0.25;
    row.flicker = {.appeared = 30, .disappeared = 20, .excused = 7, .n_counted = 10'000};
    row.pops = {.pops = 2, .runs = 5, .steps = 60};
    row.lives = {4, 0, 1, 1};
    row.lives_cut = 2;
    row.images_hash = "abc";
    return row;
}

TEST(MotionTable, IsEmptyBehindTheSequenceWhereACellFailed) {
    MotionRow row = hand_made_motion();
    EXPECT_EQ(motion_line(4, row), "4,10,60,0.25,0.005,30,20,7,10000,2,2,5,60,6,2,1\n");
    EXPECT_EQ(life_lines(4, row), "4,1,4\n4,3,1\n4,4,1\n");
    row.status = "failed";
    EXPECT_EQ(motion_line(4, row), "4,10,60,0.25,,,,,,,,,,,,\n");
}

TEST(MotionFaults, NameATruthThatIsNotPerfect) {
    MotionRow row = hand_made_motion();
    EXPECT_TRUE(motion_faults({row}).empty()) << "methods may be as bad as they are";
    row.method = "oracle";
    EXPECT_EQ(motion_faults({row}).size(), 1U);
    row.lives.clear();
    row.pops.pops = 0;
    EXPECT_THAT(motion_faults({row}).front(), HasSubstr("50 px of flicker"));
    row.flicker = {.excused = 9, .n_counted = 100};
    EXPECT_TRUE(motion_faults({row}).empty());
}

}  // namespace
}  // namespace ink::studies
