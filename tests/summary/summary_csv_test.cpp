#include "summary/summary_csv.h"

#include <gmock/gmock.h>

#include <map>

namespace ink::summary {
namespace {

/// Line `at` of the table, from 1, by its columns.
std::map<std::string, std::string> line_of(const std::string& csv, std::size_t at) {
    const core::CsvTable table = core::split_csv(csv, "summary.csv");
    std::map<std::string, std::string> line;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        line[table.columns[i]] = core::unquoted(table.records.at(at - 1).at(i));
    return line;
}

/// `k` of 100 true pixels found and 100 drawn, in 2 ms.
harness::Row scored_row(const std::string& method, const std::string& scene, std::int64_t k) {
    harness::Row row;
    row.method = method;
    row.scene = scene;
    row.view = "front";
    row.split = scene == "cube" ? "train" : "heldout";
    row.k_2px = k;
    row.n_pred = row.n_truth = 100;
    row.f_2px = static_cast<double>(k) / 100;
    row.by_class = {{"crease", {k, 100, 100}}};
    row.draw_ns = 2'000'000;
    row.bytes_per_px = 5;
    return row;
}

std::string csv_of(const std::vector<harness::Row>& rows,
                   const std::vector<statistics::CellCurve>& curves = {}) {
    Comparison comparison = compare_methods(rows);
    add_curves(curves, comparison.summaries);
    return summary_csv(rows, comparison);
}

TEST(SummaryCsv, WithoutRowsIsTheHeading) {
    EXPECT_EQ(csv_of({}),
              "method,kind,answer,answer_share,views,scenes,failed,f_2px,f_lo,f_hi,error_scene,"
              "error_scene_share,"
              "f_train,f_heldout,f_real,f_macro,f_kinds,f_1px,precision,"
              "recall,ap,draw_ms,draw_ms_lo,draw_ms_hi,bytes_per_px,"
              "recall_contour,recall_contour_lo,recall_contour_hi,"
              "recall_boundary,recall_boundary_lo,recall_boundary_hi,"
              "recall_crease,recall_crease_lo,recall_crease_hi,"
              "recall_intersection,recall_intersection_lo,recall_intersection_hi,"
              "recall_seam,recall_seam_lo,recall_seam_hi,"
              "recall_intersection_above_crease,recall_intersection_above_crease_lo,"
              "recall_intersection_above_crease_hi,"
              "recall_intersection_below_crease,recall_intersection_below_crease_lo,"
              "recall_intersection_below_crease_hi\n");
}

TEST(KindsCsv, HasALinePerMethodAndKindAndIsEmptyWithoutKinds) {
    harness::Row car = scored_row("a", "car", 80);
    harness::Row van = scored_row("a", "van", 60);
    harness::Row oak = scored_row("a", "oak", 50);
    EXPECT_EQ(kinds_csv(summarise({car, van, oak})), "");
    car.scene_kind = van.scene_kind = "vehicle";
    oak.scene_kind = "foliage";
    EXPECT_EQ(kinds_csv(summarise({car, van, oak})),
              "method,scene_kind,scenes,f_2px,least_scene,f_least\n"
              "a,vehicle,2,0.7,van,0.6\n"
              "a,foliage,1,0.5,oak,0.5\n");
    EXPECT_EQ(line_of(csv_of({car, van, oak}), 1).at("f_kinds"), "0.6");
    car.soft = {.matched_px = 3, .missing_px = 2};
    van.soft = {.matched_px = 1, .missing_px = 6};
    oak.soft = {.matched_px = 1};
    EXPECT_EQ(kinds_csv(summarise({car, van, oak})),
              "method,scene_kind,scenes,f_2px,least_scene,f_least,soft_f,soft_least_scene,"
              "soft_least\n"
              "a,vehicle,2,0.7,van,0.6,0.5,van,0.25\n"
              "a,foliage,1,0.5,oak,0.5,1,oak,1\n");
    EXPECT_EQ(line_of(csv_of({car, van, oak}), 1).at("soft_kinds"), "0.75");
}

TEST(SummaryCsv, PoolsTheRowsOfAMethod) {
    harness::Row slow = scored_row("a", "torus", 75);
    slow.draw_ns = 4'000'000;
    const auto line = line_of(csv_of({scored_row("a", "cube", 25), slow}), 1);
    EXPECT_EQ(line.at("method"), "a");
    EXPECT_EQ(line.at("kind"), "method");
    EXPECT_EQ(line.at("views"), "2");
    EXPECT_EQ(line.at("scenes"), "2");
    EXPECT_EQ(line.at("failed"), "0");
    EXPECT_EQ(line.at("f_2px"), "0.5");  // 2 * 100 / 400
    EXPECT_EQ(line.at("f_train"), "0.25");
    EXPECT_EQ(line.at("f_heldout"), "0.75");
    EXPECT_EQ(line.at("precision"), "0.5");
    EXPECT_EQ(line.at("recall"), "0.5");
    EXPECT_EQ(line.at("draw_ms"), "3");
    EXPECT_EQ(line.at("draw_ms_lo"), "2.5");
    EXPECT_EQ(line.at("draw_ms_hi"), "3.5");
    EXPECT_EQ(line.at("bytes_per_px"), "5");
    EXPECT_EQ(line.at("recall_crease"), "0.5");
    EXPECT_EQ(line.at("f_lo"), "") << "of two scenes";
    EXPECT_EQ(line.at("error_scene"), "cube");
    EXPECT_EQ(line.at("error_scene_share"), "0.75");  // 150 of 200 wrong pixels
    EXPECT_EQ(line.at("answer"), "both");
}

TEST(SummaryCsv, IsEmptyWhereThereIsNothing) {
    harness::Row failed = scored_row("a", "cube", 1);
    failed.status = "failed: no ink";
    failed.f_2px.reset();
    const auto line = line_of(csv_of({failed}), 1);
    EXPECT_EQ(line.at("failed"), "1");
    EXPECT_EQ(line.at("views"), "0");
    for (const auto& [column, field] : line) {
        const bool is_known = column == "method" || column == "kind" || column == "views" ||
                              column == "scenes" || column == "failed";
        EXPECT_EQ(field.empty(), !is_known) << column << " = " << field;
    }
}

TEST(SummaryCsv, AClassOfFewScenesHasNoInterval) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 6; ++i)
        rows.push_back(scored_row("a", std::to_string(i), 20 + 10 * i));
    EXPECT_NE(line_of(csv_of(rows), 1).at("recall_crease_lo"), "");
    rows.back().by_class.clear();
    const auto line = line_of(csv_of(rows), 1);
    EXPECT_EQ(line.at("recall_crease"), "0.4");
    EXPECT_EQ(line.at("recall_crease_lo"), "");
    EXPECT_NE(line.at("f_lo"), "");
}

TEST(SummaryCsv, BaselinesComeLastAndCurvesGiveAveragePrecision) {
    statistics::CellCurve curve{.method = "a"};
    curve.counts.fill({50, 50, 100});  // precision 1 up to recall 0.5, nothing beyond
    const std::string csv =
        csv_of({scored_row("oracle", "cube", 100), scored_row("a", "cube", 50)}, {curve});
    EXPECT_EQ(line_of(csv, 1).at("method"), "a");
    EXPECT_EQ(line_of(csv, 1).at("ap"), "0.5");
    EXPECT_EQ(line_of(csv, 2).at("method"), "oracle");
    EXPECT_EQ(line_of(csv, 2).at("kind"), "baseline");
    EXPECT_EQ(line_of(csv, 2).at("ap"), "");
}

std::vector<harness::Row> seven_scenes() {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 7; ++i) {
        for (const char* method : {"a", "b", "sampled"})
            rows.push_back(scored_row(method, std::to_string(i), 20 + 7 * i + method[0] % 5 * i));
    }
    return rows;
}

TEST(Comparison, OfInkIsByTheSameRuleOverItsCounts) {
    std::vector<harness::Row> rows = seven_scenes();
    const Comparison plain = compare_methods(rows);
    EXPECT_THAT(comparison_tables(rows, plain).at("summary.csv"),
                testing::Not(testing::HasSubstr("soft_f")));
    for (harness::Row& row : rows) {
        const auto k = static_cast<double>(row.k_2px);
        row.soft = {
            1.5, k, 0, static_cast<double>(row.n_truth) - k, static_cast<double>(row.n_pred) - k};
    }
    const Comparison of_ink = compare_methods(rows);
    const auto tables = comparison_tables(rows, of_ink);
    EXPECT_EQ(tables.at("differences.csv"), comparison_tables(rows, plain).at("differences.csv"));
    EXPECT_EQ(tables.at("soft_differences.csv"), tables.at("differences.csv"));
    EXPECT_EQ(of_ink.shares, plain.shares);
    const auto line = line_of(tables.at("summary.csv"), 1);
    EXPECT_EQ(line.at("soft_f"), line.at("f_2px"));
    EXPECT_EQ(line.at("soft_lo"), line.at("f_lo"));
}

TEST(SummaryCsv, AMethodsNameIsQuotedWhereItMustBe) {
    const std::string csv = csv_of({scored_row("a,\"b\"", "cube", 50)});
    EXPECT_NE(csv.find("\n\"a,\"\"b\"\"\",method,both,,1,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace ink::summary
