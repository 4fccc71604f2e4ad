#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.h"

// `inkbench timedemo` as a user runs it.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Timedemo, PrintsItsTableAndWritesItsFrames) {
    const Desk desk;
    const Outcome outcome = desk.run({"timedemo",
                                      "gear",
                                      "--methods",
                                      "mote4",
                                      "--frames",
                                      "2",
                                      "--size",
                                      "64x48",
                                      "--out",
                                      "demo"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* row : {"plain", "shading", "no edges", "full", "orbit, first", "cached"})
        EXPECT_THAT(outcome.out, HasSubstr(row));
    EXPECT_EQ(parse_csv(desk.read("demo/timedemo.csv")).size(), 3U * 3 * 2)
        << "paths, passes, frames";
}

TEST(Timedemo, RefusesAMomentAndAbsurdNumbersOfFrames) {
    const Desk desk;
    EXPECT_EQ(desk.run({"timedemo", "gear", "--time", "1"}).exit_code, 2);
    for (const char* frames : {"0", "1", "-3", "10001", "many"}) {
        const Outcome outcome = desk.run({"timedemo", "gear", "--frames", frames, "--out", "demo"});
        EXPECT_EQ(outcome.exit_code, 2) << frames;
        EXPECT_THAT(outcome.err, HasSubstr("--frames")) << frames;
        EXPECT_TRUE(desk.inventory().empty()) << frames;
    }
}

}  // namespace
}  // namespace ink::program
