// The oracle is the truth itself: it has 1 in every column that is an F, whatever counts there.

#include <gtest/gtest.h>

#include "core/tables/csv_table.h"
#include "harness/rows/row_table.h"
#include "tests/harness/baselines.h"
#include "tests/harness/random_rows.h"

namespace ink::harness {
namespace {

struct Case {
    const char* scene;
    std::pair<int, int> size_px;
    score::Intersections intersections;
};

/// Columns that hold an F, or the recall of a class, of the row's own image; a random image stands
/// beside it.
std::vector<std::size_t> columns_of_f() {
    std::vector<std::size_t> columns;
    const auto& all = rows_table().info().columns;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string& name = all[i].name;
        const bool is_f = name.starts_with("f_") && name != "f_random_2px";
        if (is_f || name == "soft_f" || name.starts_with("recall_")) columns.push_back(i);
    }
    return columns;
}

class Oracle : public testing::TestWithParam<Case> {};

TEST_P(Oracle, IsOneInEveryColumnThatIsAnFAndNoneIsZero) {
    const auto& all = rows_table().info().columns;
    const Case& of = GetParam();
    EXPECT_GE(columns_of_f().size(), 5U);
    for (const bool is_full : {true, false}) {
        std::vector<Evaluation> evaluations =
            baselines_of(of.scene, of.size_px, is_full, of.intersections);
        std::vector<std::string> faults;
        check_baselines(evaluations, faults);
        EXPECT_TRUE(faults.empty()) << faults.front();
        for (const Evaluation& evaluation : evaluations) {
            const Row& row = evaluation.row;
            if (row.method != "oracle" && row.method != "none") continue;
            const std::vector<std::string> fields =
                file_of(rows_table(), row_line(0, Study::compare, row)).records.at(0);
            ASSERT_EQ(fields.size(), all.size());
            for (const std::size_t i : columns_of_f()) {
                SCOPED_TRACE(row.method + " " + all[i].name);
                const bool may_lack = !row.is_ok() || all[i].name.starts_with("recall_") ||
                                      (!is_full && all[i].name == "f_1px");
                if (may_lack && fields[i].empty()) continue;
                EXPECT_EQ(fields[i], row.method == "oracle" ? "1" : "0");
            }
        }
        // Else the law would hold of a table without numbers.
        EXPECT_TRUE(evaluations.back().row.with_crowded_2px.has_value());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Every,
    Oracle,
    testing::Values(
        // Too crowded to be scored; crowded, and scored; flat intersections; neither.
        Case{"bush", {240, 135}, score::Intersections::above_crease},
        Case{"bush", {640, 360}, score::Intersections::above_crease},
        Case{"bush", {640, 360}, score::Intersections::all},
        Case{"tree", {320, 180}, score::Intersections::above_crease},
        Case{"tree", {320, 180}, score::Intersections::all},
        Case{"cube", {320, 180}, score::Intersections::above_crease}),
    [](const auto& of) { return of.param.scene + std::string("_") + std::to_string(of.index); });

TEST(Baselines, AnOracleBelowOneOrADrawnNoneIsAFault) {
    std::vector<Evaluation> evaluations(2);
    evaluations[0].row.method = "oracle";
    evaluations[1].row.method = "none";
    for (Evaluation& evaluation : evaluations) {
        evaluation.row.f_2px = evaluation.row.f_1px = evaluation.row.method == "oracle" ? 1 : 0;
        evaluation.row.all_intersections_2px = score::CurveCount{9, 10, 10};
        evaluation.row.with_crowded_2px = score::CurveCount{8, 10, 10};
    }
    std::vector<std::string> reasons;
    check_baselines(evaluations, reasons);
    EXPECT_EQ(reasons.size(), 4U) << testing::PrintToString(reasons);
}

}  // namespace
}  // namespace ink::harness
