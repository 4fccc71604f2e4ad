#include "harness/row_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/error.h"
#include "experiment/experiment_plan.h"
#include "harness/csv.h"

namespace ink::harness {
namespace {

std::string table_of(const std::string& heading, const std::string& lines) {
    return heading + "\n" + lines;
}

std::string row_heading() {
    std::string heading;
    for (const std::string& name : row_columns())
        heading += (heading.empty() ? "" : ",") + name;
    return heading;
}

/// Real rows and curves of two scenes, every score asked for.
class ReadRealRows : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const experiment::Experiment e = experiment::parse_experiment(
            "name = \"e\"\nkind = \"compare\"\n[grid]\nscenes = [\"cube\", \"teapot\"]\n"
            "views = 2\nmethods = [\"mote4\", \"decaudin\", \"edge_list\", \"auto\"]\n"
            "sizes = [\"160x90\"]\n[measure]\nrepetitions = 1\n[sweep.mote4]\nthreshold = [3, 6]\n",
            "e.toml");
        const experiment::Plan plan = experiment::make_plan(e, {});
        for (const experiment::Block& block : plan.blocks) {
            for (const auto& [table, lines] : block.run().lines)
                lines_[table] += lines;
        }
    }
    static std::map<std::string, std::string> lines_;
};
std::map<std::string, std::string> ReadRealRows::lines_;

TEST_F(ReadRealRows, GivesTheSameFieldsAgain) {
    for (const char* name : {"rows.csv", "sweep.csv"}) {
        const CsvTable table = split_csv(table_of(row_heading(), lines_.at(name)), name);
        const std::vector<Row> rows = read_rows(table, name);
        std::string again;
        for (const Row& row : rows)
            again += to_csv(row) + "\n";
        EXPECT_EQ(again, lines_.at(name)) << name;
    }
    EXPECT_EQ(split_csv(table_of(row_heading(), lines_.at("rows.csv")), "").records.size(), 28U)
        << "2 scenes, 2 views, 4 methods and 3 brackets";
}

TEST_F(ReadRealRows, GivesTheCurvesOfMethodsWithTheirSplit) {
    const CsvTable rows = split_csv(table_of(row_heading(), lines_.at("rows.csv")), "rows.csv");
    std::string heading;
    for (const std::string& name : curve_columns())
        heading += (heading.empty() ? "" : ",") + name;
    const CsvTable table = split_csv(table_of(heading, lines_.at("curves.csv")), "curves.csv");
    const auto curves = read_curves(table, read_rows(rows, "rows.csv"), "curves.csv");
    ASSERT_EQ(curves.size(), 16U) << "2 scenes, 2 views, 4 methods, no brackets";
    EXPECT_EQ(curves.front().method, "mote4");
    EXPECT_TRUE(curves.front().is_training) << "cube";
    EXPECT_FALSE(curves.back().is_training) << "teapot";
    EXPECT_EQ(std::to_string(curves.front().counts[98].n_truth), table.records[98].back());
    EXPECT_EQ(std::to_string(curves.front().counts[0].k), table.records[0][7]);
}

TEST(ReadRows, OfAFailedCellAndOfOddNamesGivesThemBack) {
    Row row;
    row.method = "mote4";
    row.scene = "a \"b\", c\nd";
    row.status = "failed: out of ink, twice";
    row.seed = 18446744073709551615ULL;
    const std::string line = to_csv(row) + "\n";
    const auto rows = read_rows(split_csv(table_of(row_heading(), line), "t"), "t");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].scene, row.scene);
    EXPECT_EQ(rows[0].status, row.status);
    EXPECT_EQ(rows[0].seed, row.seed);
    EXPECT_FALSE(rows[0].f_2px);
    EXPECT_EQ(to_csv(rows[0]) + "\n", line);
}

TEST(ReadRows, NamesRecordColumnAndField) {
    try {
        (void)read_rows(
            split_csv("method,scene,view,params,status,f_2px\na,b,c,,ok,1\na,b,c,,ok,1x\n",
                      "t.csv"),
            "t.csv");
        FAIL() << "1x is no number";
    } catch (const core::Error& error) {
        EXPECT_STREQ(error.what(), "t.csv, record 2: column f_2px holds '1x' (accepted: a number)");
    }
    EXPECT_THROW((void)read_rows(split_csv("method\na\n", "t.csv"), "t.csv"), core::Error);
}

}  // namespace
}  // namespace ink::harness
