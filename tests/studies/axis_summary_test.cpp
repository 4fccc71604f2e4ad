#include "studies/axis_summary.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "method/method.h"
#include "tests/report/markup.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;
using testing::Not;

AxisRow row_of(const std::string& method, double value, const std::string& scene, int k) {
    AxisRow row;
    row.row.axis = "grazing";
    row.row.value = value;
    row.row.seed = 1;
    row.row.method = method;
    row.row.scene = scene;
    row.row.k_2px = k;
    row.row.n_pred = 100;
    row.row.n_truth = 100;
    row.row.f_2px = k / 100.0;
    return row;
}

std::vector<AxisRow> some_rows() {
    std::vector<AxisRow> rows;
    for (const char* scene : {"a", "b"}) {
        rows.push_back(row_of("sampled", 0.1, scene, 99));
        rows.push_back(row_of("steady", 0.1, scene, 90));
        rows.push_back(row_of("mote4", 0.1, scene, *scene == 'a' ? 30 : 50));
        rows.push_back(row_of("sampled", 20, scene, 99));
        rows.push_back(row_of("steady", 20, scene, 91));
        rows.push_back(row_of("mote4", 20, scene, 80));
    }
    return rows;
}

TEST(AxisSummary, PoolsTheCasesOfAPoint) {
    const auto points = summarise_axes(some_rows());
    ASSERT_EQ(points.size(), 6U);
    EXPECT_EQ(points[2].method, "mote4");
    EXPECT_EQ(points[2].value, 0.1);
    EXPECT_EQ(points[2].cases, 2);
    EXPECT_DOUBLE_EQ(points[2].f.value(), 0.4);
    EXPECT_DOUBLE_EQ(points[2].error().value(), 0.6);
    EXPECT_EQ(points[2].truth_px, 200);
    EXPECT_FALSE(points[2].f_range) << "of two cases";
}

TEST(AxisSummary, HasSoftFWhereGreyLinesAreScored) {
    auto rows = some_rows();
    EXPECT_THAT(axis_summary_csv(summarise_axes(rows)), Not(HasSubstr("soft_f")));
    for (AxisRow& row : rows)
        row.row.soft = {.matched_px = row.row.scene == "a" ? 1.0 : 5.0, .missing_px = 8};
    const auto points = summarise_axes(rows);
    EXPECT_DOUBLE_EQ(points[2].soft->f().value(), 2 * 6.0 / (6 + 22));
    EXPECT_THAT(axis_summary_csv(points),
                HasSubstr(",truth_px,soft_f,soft_lo,soft_hi,non_finite,"));
}

TEST(AxisSummary, SixCasesGiveAnInterval) {
    std::vector<AxisRow> rows;
    for (int i = 0; i < 6; ++i)
        rows.push_back(row_of("mote4", 0.1, std::to_string(i), 30 + 4 * i));
    const auto points = summarise_axes(rows);
    ASSERT_TRUE(points.at(0).f_range);
    EXPECT_LT(points[0].f_range->low, 0.4);
    EXPECT_GT(points[0].f_range->high, 0.4);
    EXPECT_FALSE(points[0].soft_range);
    for (AxisRow& row : rows)
        row.row.soft = {.matched_px = *row.row.f_2px, .missing_px = 1 - *row.row.f_2px};
    const auto inked = summarise_axes(rows);
    ASSERT_TRUE(inked.at(0).soft_range);
    EXPECT_LT(inked[0].soft_range->low, *inked[0].soft->f());
    EXPECT_GT(inked[0].soft_range->high, *inked[0].soft->f());
}

TEST(AxisSummary, ALostCellIsCountedAndNotScored) {
    auto rows = some_rows();
    rows[2].row.status = "failed: no ink";
    rows[2].faults.lost = 1;
    const auto points = summarise_axes(rows);
    EXPECT_EQ(points[2].cases, 1);
    EXPECT_DOUBLE_EQ(points[2].f.value(), 0.5);
    EXPECT_FALSE(points[2].f_range);
    EXPECT_EQ(points[2].faults.lost, 1);
    EXPECT_THAT(axis_summary_csv(points), HasSubstr("grazing,0.1,mote4,1,0.5,,,100,"));
}

TEST(AxisCurves, KnowTheirBestAndWorstPoint) {
    const auto curves = axis_curves(summarise_axes(some_rows()), "grazing");
    ASSERT_EQ(curves.size(), 3U);
    EXPECT_NEAR(curves[2].loss(), 0.4, 1e-12);
}

TEST(StressFinding, NamesTheAxisThatBreaksEachMethod) {
    auto rows = some_rows();
    for (const int k : {80, 70}) {  // less than along the other axis
        rows.push_back(row_of("mote4", k, "a", k));
        rows.back().row.axis = "origin";
    }
    EXPECT_EQ(stress_finding(summarise_axes(rows)).first,
              "grazing breaks mote4 first (error .20 to .60 at 0.1°); no axis breaks steady");
    EXPECT_EQ(stress_finding({}).first, "");
}

TEST(StressFinding, OfManyMethodsSaysHowManyAnAxisBreaks) {
    std::vector<AxisRow> rows = some_rows();
    for (const char* method : {"ids", "sobel", "label8"})
        for (const double value : {1.0, 2.0})
            rows.push_back(row_of(method, value, "a", value == 1 ? 90 : 20));
    const Finding finding = stress_finding(summarise_axes(rows));
    EXPECT_EQ(finding.first, "grazing breaks 4 of 5 methods first");
    EXPECT_THAT(
        finding.rest,
        HasSubstr(
            "; grazing breaks mote4 first (error .20 to .60 at 0.1°); no axis breaks steady."));
}

TEST(StressTable, HasALinePerAxisThatRan) {
    const std::string table = stress_table(summarise_axes(some_rows()));
    EXPECT_THAT(table, HasSubstr("grazing"));
    EXPECT_THAT(table, HasSubstr("mote4"));
    EXPECT_THAT(table, Not(HasSubstr("cube_roll")));
}

}  // namespace
}  // namespace ink::studies
