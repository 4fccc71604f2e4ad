#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// `inkbench bound` as a user runs it.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Bound, PrintsItsTableAndWritesTheSame) {
    const Desk desk;
    const std::string out = expect_done(desk, "bound cube gem tiles --size 160x90 --out bounds");
    for (const char* text : {"F upper", "cube", "gem", "tiles", "(training)", "(all)"})
        EXPECT_THAT(out, HasSubstr(text));
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
        const char* words = "bound gem --size 160x90 --signed --boxes 500 --threads {0} --out {0}";
        expect_done(desk, fmt::format(fmt::runtime(words), threads));
    }
    EXPECT_EQ(desk.read("1/bound.csv"), desk.read("3/bound.csv"));
}

TEST(Bound, RefusesWhatIsNotLinear) {
    const Desk desk;
    for (const std::string arguments : {"--method decaudin",
                                        "--method mote4,mote16",
                                        "--set overflow=wrap",
                                        "--set sky=5",
                                        "--gap -1",
                                        "--boxes 0",
                                        "--least-threshold -1"})
        EXPECT_THAT(refusal(desk, "bound cube --size 64x48 " + arguments), HasSubstr("accepted"));
}

}  // namespace
}  // namespace ink::program
