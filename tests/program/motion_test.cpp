#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

TEST(CompareMotion, WritesItsFilesAndTheSectionAndOnlyIfAsked) {
    const Desk desk;
    Words words =
        "compare --scenes cube --methods mote4 --size 64x36 --repetitions 1 --no-sweep "
        "--no-crosscheck --out out --motion";
    expect_done(desk, words);

    std::set<std::string> scenes;
    for (const auto& line : table_of_run(desk, "out", "motion.csv")) {
        EXPECT_EQ(line.at("status"), "ok");
        scenes.insert(line.at("scene"));
        if (line.at("method") != "oracle") continue;
        EXPECT_EQ(std::stod(line.at("flicker")), 0) << line.at("scene");
        EXPECT_EQ(line.at("pops"), "0");
        EXPECT_EQ(line.at("false_lines"), "0");
    }
    EXPECT_EQ(scenes, (std::set<std::string>{"cube", "figure", "gear", "torus", "tree"}));

    EXPECT_GT(page_table(desk, "out", "motion.csv")["lines"], 0);

    words.back() = "--force";
    expect_done(desk, words);
    EXPECT_EQ(desk.read("out/motion.csv"), "") << "an older one must not pass for this run's";
    EXPECT_TRUE(page_table(desk, "out", "motion.csv").is_null());
}

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
            EXPECT_EQ(line.at("ink_beyond"), "0");
        }
    }
    desk.write("smooth.toml", file);
    expect_done(desk, "run smooth.toml --force");
    EXPECT_EQ(desk.read("inkbench-out/smooth/ink_motion.csv"), "");
}

}  // namespace
}  // namespace ink::program
