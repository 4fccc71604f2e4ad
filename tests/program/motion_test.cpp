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

}  // namespace
}  // namespace ink::program
