#include "harness/rows/side_tables.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "harness/cells/cell.h"
#include "tests/core/error_text.h"
#include "tests/harness/random_rows.h"

namespace ink::harness {
namespace {

/// Three rows, the first two of which have a score.
std::vector<RowRecord> three_rows() {
    std::vector<RowRecord> rows(3);
    for (std::size_t i = 0; i < 3; ++i) {
        rows[i].cell = static_cast<std::int64_t>(10 * i + 7);
        rows[i].row.method = std::string("m").append(std::to_string(i));
        rows[i].row.split = i == 1 ? "train" : "heldout";
        if (i < 2) rows[i].row.f_2px = 1;
    }
    return rows;
}

std::array<score::CurveCount, 99> random_curve(RandomValues& any) {
    std::array<score::CurveCount, 99> counts;
    for (score::CurveCount& count : counts)
        count = random_counts(any);
    return counts;
}

TEST(CurvesTable, ReadsAndWritesTheSameBytes) {
    RandomValues any(1);
    const std::vector<RowRecord> rows = three_rows();
    const std::string lines =
        curve_lines(27, random_curve(any)) + curve_lines(17, random_curve(any));
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2 * 99);
    const auto curves = read_curves(file_of(curves_table(), lines), RowIndex(rows));
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_EQ(curves[0].curve.method, "m2");
    std::string again;
    for (const CurveRecord& curve : curves)
        again += curve_lines(curve.cell, curve.curve.counts);
    EXPECT_EQ(again, lines);
}

TEST(CurvesTable, RefusesWhatIsNoWholeCurveOfAKnownCell) {
    const std::vector<RowRecord> rows = three_rows();
    const auto error = [&](const std::string& lines) {
        return core::error_text(
            [&] { (void)read_curves(file_of(curves_table(), lines), RowIndex(rows)); });
    };
    const std::string curve = curve_lines(7, {});
    EXPECT_EQ(error(curve), "");
    EXPECT_EQ(error(curve_lines(8, {})),
              "curves.csv, line 2: column cell holds '8' (accepted: the number of a cell of "
              "rows.csv)");
    EXPECT_EQ(error(curve.substr(0, curve.find("7,99,"))),
              "curves.csv, line 99: column threshold holds '98' (accepted: 99 on the last line)");
    std::string twice = curve;
    twice.insert(0, "7,1,0,0,0\n");
    EXPECT_THAT(error(twice), testing::HasSubstr("line 3: column threshold holds '1'"));
    std::string mixed = curve;
    mixed.replace(mixed.find("7,50,"), 5, "17,50,");
    EXPECT_THAT(error(mixed), testing::HasSubstr("line 51: column cell holds '17'"));
    EXPECT_THAT(error("7,1,0,0.5,0\n"), testing::HasSubstr("column n_pred holds '0.5'"));
}

TEST(TolerancesTable, GoesBackIntoTheRowsAsItWas) {
    RandomValues any(2);
    std::vector<RowRecord> rows = three_rows();
    std::vector<std::vector<score::CurveCount>> ladders(2);
    for (auto& tolerance_sweep : ladders) {
        for (std::size_t i = 0; i < kTolerances_px.size(); ++i)
            tolerance_sweep.push_back(random_counts(any));
    }
    const std::string lines = tolerance_lines(7, ladders[0]) + tolerance_lines(27, ladders[1]);
    join_tolerances(file_of(tolerances_table(), lines), rows);
    EXPECT_EQ(rows[0].row.tolerance_sweep, ladders[0]);
    EXPECT_TRUE(rows[1].row.tolerance_sweep.empty());
    EXPECT_EQ(rows[2].row.tolerance_sweep, ladders[1]);
    EXPECT_EQ(tolerance_lines(7, rows[0].row.tolerance_sweep) +
                  tolerance_lines(27, rows[2].row.tolerance_sweep),
              lines);
    EXPECT_EQ(tolerance_lines(1, {}), "");
}

TEST(TolerancesTable, RefusesOtherTolerancesThanThoseOfEveryCell) {
    const auto error = [](const std::string& lines) {
        return core::error_text([&] {
            std::vector<RowRecord> rows = three_rows();
            join_tolerances(file_of(tolerances_table(), lines), rows);
        });
    };
    EXPECT_EQ(error("7,1,0,0,0\n7,1.5,0,0,0\n"), "");
    EXPECT_THAT(error("7,1,0,0,0\n7,2,0,0,0\n"),
                testing::HasSubstr("line 3: column tolerance_px holds '2' (accepted: 1.5"));
    EXPECT_THAT(error("9,1,0,0,0\n"), testing::HasSubstr("column cell holds '9'"));
}

TEST(BinsTable, GoesBackIntoRowsAsItWas) {
    std::vector<RowRecord> rows = three_rows();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<BinCount> bins = {
        {0, 20, 40, 1, 2}, {1, infinity, infinity, 3, 4}, {3, 0.2, 0.4, 0, 1}};
    const std::string lines = bin_lines(17, bins);
    EXPECT_EQ(lines,
              "17,dihedral_deg,20,40,1,2\n17,relative_gap,inf,inf,3,4\n"
              "17,relative_distance,0.2,0.4,0,1\n");
    join_bins(file_of(bins_table(), lines), rows);
    EXPECT_TRUE(rows[0].row.bins.empty());
    EXPECT_EQ(bin_lines(17, rows[1].row.bins), lines);
    EXPECT_EQ(bin_lines(17, {}), "");
}

TEST(BinsTable, RefusesUnknownAttributesAndRowsWithoutAScore) {
    const auto error = [](const std::string& lines) {
        return core::error_text([&] {
            std::vector<RowRecord> rows = three_rows();
            join_bins(file_of(bins_table(), lines), rows);
        });
    };
    EXPECT_EQ(error("7,shine,0,1,0,1\n"),
              "bins.csv, line 2: column attribute holds 'shine' (accepted: dihedral_deg, "
              "relative_gap, view_angle_deg, relative_distance)");
    EXPECT_THAT(error("27,relative_gap,0,1,0,1\n"), testing::HasSubstr("has a score"));
}

}  // namespace
}  // namespace ink::harness
