#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.h"

// `inkbench page`, as a user runs it; tests/page uses what it makes.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(LivePageProgram, LiesInTheFolderOfItsRunWhichLinksToIt) {
    const Desk desk;
    expect_done(desk, "compare cube --methods surface8 --quick --size 64x36 --out run");
    EXPECT_THAT(desk.read("run/report.html"), HasSubstr(R"("live":{})"));
    expect_done(desk, "page cube --run run");
    EXPECT_THAT(desk.read("run/live/cube.html"), HasSubstr("surface8"));
    expect_done(desk, "report run");
    EXPECT_THAT(desk.read("run/report.html"), HasSubstr(R"("live":{"cube":"live/cube.html"})"));
}

TEST(LivePageProgram, RefusesWithOneLineAndLeavesNothing) {
    const Desk desk;
    desk.write("empty.obj", "");
    expect_refused(desk, "page cube", {"there is no file to write", "-o FILE, or --run DIR"});
    expect_refused(desk, "page cube -o a.png", {"a.png", ".html"});
    expect_refused(desk, "page empty.obj -o a.html", {"empty.obj", "the file is empty"});
    EXPECT_THAT(desk.inventory(), testing::SizeIs(1));
}

}  // namespace
}  // namespace ink::program
