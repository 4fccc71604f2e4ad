#include <gmock/gmock.h>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

TEST(Animation, FollowsAnySceneAndTheChangeOfItsInk) {
    const Desk desk;
    const std::string file =
        "name = \"smooth\"\nkind = \"animation\"\n[grid]\nscenes = [\"bars\", \"rocket\"]\n"
        "paths = [\"pan\"]\nframes = 3\nstep_px = 0.125\nsizes = [\"64x36\"]\n"
        "methods = [\"strokes\", \"ids\"]\nantialias = [\"none\", \"resolve4\"]\n";
    desk.write("smooth.toml", file + "[measure]\ncoverage = true\n");
    expect_done(desk, "run smooth.toml");
    const Table lines = table_of_run(desk, "inkbench-out/smooth", "ink_motion.csv");
    EXPECT_EQ(lines.size(), 2U * (3 + 3)) << "three methods and three baselines";
    for (const auto& line : lines) {
        EXPECT_EQ(line.at("view"), "pan");
        EXPECT_NE(line.at("soft_f"), "");
        if (line.at("method") == "oracle") {
            EXPECT_EQ(line.at("ink_beyond_px"), "0");
        }
    }
    desk.write("smooth.toml", file);
    expect_done(desk, "run smooth.toml --force");
    EXPECT_EQ(desk.read("inkbench-out/smooth/ink_motion.csv"), "");
}

}  // namespace
}  // namespace ink::program
