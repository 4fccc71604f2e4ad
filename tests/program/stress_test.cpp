#include <fmt/format.h>
#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;

Words small_run(const std::string& out) {
    return fmt::format(
        "stress --axes grazing,threads --methods mote4,edge_list --points 3 --size 96x54 "
        "--no-cache --out {}",
        out);
}

TEST(Stress, WritesRowsSummaryAxesAndPage) {
    const Desk desk;
    EXPECT_THAT(expect_done(desk, small_run("out")), HasSubstr("grazing"));
    const Table rows = table_of_run(desk, "out", "stress.csv");
    // Three values of three and of four cases, each with four baselines and two methods.
    EXPECT_EQ(rows.size(), 3U * (3 + 4) * 6);
    std::set<std::string> values;
    for (const auto& row : rows) {
        EXPECT_EQ(row.at("status"), "ok");
        EXPECT_EQ(row.at("lost_cell"), "0");
        EXPECT_EQ(row.at("draw_ns"), "");
        if (row.at("axis") == "grazing") values.insert(row.at("value"));
        EXPECT_EQ(row.at("threads"), row.at("axis") == "threads" ? row.at("value") : "1");
    }
    EXPECT_EQ(values, (std::set<std::string>{"0.1", "2", "20"}));
    EXPECT_EQ(parse_csv(desk.read("out/axis_summary.csv")).size(), 3U * 2 * 6);
    EXPECT_EQ(parse_csv(desk.read("out/axes.csv")).size(), 2U);
    EXPECT_EQ(page_table(desk, "out", "stress.csv")["lines"], rows.size());
    EXPECT_EQ(page_table(desk, "out", "axes.csv")["lines"], 2);
}

TEST(Stress, RefusesWhatItDoesNotKnow) {
    const Desk desk;
    EXPECT_THAT(refusal(desk, "stress --axes grazin"), HasSubstr("grazing"));
    refusal(desk, "stress --axes zoom,zoom");
    refusal(desk, "stress --points 1");
    EXPECT_THAT(expect_done(desk, {"list", "axes"}), HasSubstr("cube_roll"));
}

}  // namespace
}  // namespace ink::program
