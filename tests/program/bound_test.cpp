#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// `inkbench bound` as a user runs it.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Bound, PrintsItsTableAndWritesTheSame) {
    const Desk desk;
    const Outcome outcome =
        desk.run({"bound", "cube", "gem", "tiles", "--size", "160x90", "--out", "bounds"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* text : {"F upper", "cube", "gem", "tiles", "(training)", "(all)"})
        EXPECT_THAT(outcome.out, HasSubstr(text));
    const Table rows = table_of_run(desk, "bounds", "bound.csv");
    ASSERT_EQ(rows.size(), 5U) << "a held-out pool of one scene would be that scene again";
    EXPECT_EQ(rows[1].at("scene"), "gem");
    EXPECT_EQ(rows[1].at("split"), "heldout");
    for (const auto& row : rows) {
        const double upper = std::stod(row.at("f_upper"));
        EXPECT_LE(std::stod(row.at("f_found")), upper);
        EXPECT_LE(std::stod(row.at("f_model")), upper);
        EXPECT_LE(std::stod(row.at("f_2px")), upper + 0.005);
        EXPECT_LE(std::stod(row.at("gap")), 0.0051);
        EXPECT_GT(std::stol(row.at("n_truth")), 0);
    }
}

TEST(Bound, IsTheSameForEveryThreadCount) {
    const Desk desk;
    for (const char* threads : {"1", "3"}) {
        const Outcome outcome = desk.run({"bound",
                                          "gem",
                                          "--size",
                                          "160x90",
                                          "--signed",
                                          "--boxes",
                                          "500",
                                          "--threads",
                                          threads,
                                          "--out",
                                          threads});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    EXPECT_EQ(desk.read("1/bound.csv"), desk.read("3/bound.csv"));
}

TEST(Bound, RefusesWhatIsNotLinear) {
    const Desk desk;
    const std::vector<std::vector<std::string>> refused = {
        {"--method", "decaudin"},
        {"--method", "mote4,mote16"},
        {"--set", "overflow=wrap"},
        {"--set", "sky=5"},
        {"--gap", "-1"},
        {"--boxes", "0"},
        {"--least-threshold", "-1"},
    };
    for (const auto& arguments : refused) {
        std::vector<std::string> all = {"bound", "cube", "--size", "64x48"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome outcome = desk.run(all);
        EXPECT_EQ(outcome.exit_code, 2) << arguments.back();
        EXPECT_THAT(outcome.err, HasSubstr("accepted")) << arguments.back();
    }
    EXPECT_TRUE(desk.inventory().empty());
}

}  // namespace
}  // namespace ink::program
