#include <fmt/format.h>
#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

// A run in shares, before all of them are done.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kSharedRun = R"(name = "tiny"
kind = "compare"
[grid]
scenes = ["cube", "rocket", "letters"]
views = 1
methods = ["mote4", "ids"]
sizes = ["96x54"]
[measure]
repetitions = 1
times = false
[sweep.mote4]
threshold = [3, 6, 12]
)";

TEST(Shares, StatusCountsBlocksOfTheRunAndOfEachShare) {
    const Desk desk;
    desk.write("tiny.toml", kSharedRun);
    EXPECT_THAT(desk.run("run tiny.toml --status --out out").out,
                HasSubstr("tiny: 0 of 6 blocks are done"));
    expect_done(desk, "run tiny.toml --shard 2/2 --out out.parts/2-of-2");
    const std::string half = desk.run("run tiny.toml --status --out out").out;
    EXPECT_THAT(half, AllOf(HasSubstr("of 6 blocks are done"), HasSubstr("out.parts/2-of-2: ")));
    expect_done(desk, "run tiny.toml --shard 1/2 --out out.parts/1-of-2");
    EXPECT_THAT(desk.run("run tiny.toml --status --out out").out,
                HasSubstr("tiny: 6 of 6 blocks are done"));
    expect_done(desk, "merge out.parts/1-of-2 out.parts/2-of-2 --out out");
    EXPECT_THAT(desk.run("run tiny.toml --status --out out").out, HasSubstr("tiny: finished"));
}

TEST(Shares, PartialTablesHoldWhatIsThereAndNothingElse) {
    const Desk desk;
    desk.write("tiny.toml", kSharedRun);
    for (const char* share : {"1/2", "2/2"}) {
        const std::string folder = std::string("part") + share[0];
        expect_done(desk, fmt::format("run tiny.toml --shard {} --out {}", share, folder));
        refusal(desk, fmt::format("merge {0} --out whole{0}", folder));  // a share is missing
        const std::string out = "some" + folder;
        const Outcome outcome = desk.run(fmt::format("merge {} --partial --out {}", folder, out));
        EXPECT_THAT(outcome.err, HasSubstr("of 6 parts are missing"));
        std::set<std::string> cells;
        for (const auto& row : rows_of(desk, out))
            cells.insert(row.at("cell"));
        EXPECT_FALSE(cells.empty());
        for (const auto& line : parse_csv(desk.read(out + "/sweep.csv")))
            EXPECT_TRUE(cells.contains(line.at("cell"))) << "a setting without its cell";
    }
}

}  // namespace
}  // namespace ink::program
