#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "tests/bench/run_command.h"

// bench/table.py on times that are made up so that every figure can be worked out by hand.

namespace ink::bench_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kTable = "python3 " INK_SOURCE_DIR "/bench/table.py ";

struct Time {
    std::string name;
    double time = 0;
    std::string unit = "ns";
};

/// What ink_bench would have written: each benchmark twice, the second time slower by a half.
std::string json_of(const std::vector<Time>& times) {
    nlohmann::json benchmarks = nlohmann::json::array();
    for (const Time& time : times) {
        for (const double factor : {1.0, 1.5}) {
            benchmarks.push_back({{"name", time.name},
                                  {"run_name", time.name},
                                  {"run_type", "iteration"},
                                  {"real_time", time.time * factor},
                                  {"time_unit", time.unit}});
        }
        // As the library writes it; it must not be taken for a time.
        benchmarks.push_back({{"name", time.name + "_cv"},
                              {"run_name", time.name},
                              {"run_type", "aggregate"},
                              {"aggregate_name", "cv"},
                              {"real_time", 1e-3},
                              {"time_unit", time.unit}});
    }
    return nlohmann::json{{"context", {{"cpu", "made up"}}}, {"benchmarks", benchmarks}}.dump();
}

/// The line of the table that begins with `work`, or "".
std::string row(const std::string& table, const std::string& work) {
    const auto begin = table.find("| " + work);
    return begin == table.npos ? "" : table.substr(begin, table.find('\n', begin) - begin);
}

std::string table_of(const std::vector<Time>& times) {
    const Desk desk;
    const Outcome outcome = run(kTable + desk.write("run.json", json_of(times)));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    return outcome.text;
}

TEST(SpeedTable, GivesRatiosOfLeastTimes) {
    const std::string table = table_of({{"memcpy/u8/1080p", 50'000},
                                        {"filter/laplacian/u8/1080p", 40, "us"},
                                        {"opencv/laplacian/u8/1080p", 0.4, "ms"}});
    EXPECT_EQ(row(table, "u8 four"),
              "| u8 four-neighbour Laplacian, scale, clip | a copy of as many bytes, OpenCV | >= 9 "
              "x OpenCV | 1.25 of copy; 10.0 x OpenCV | met |");
    EXPECT_THAT(table, HasSubstr("Least of 2 or more interleaved repetitions, made up"));
}

TEST(SpeedTable, MarksWhatIsMissed) {
    const std::string table = table_of({{"memcpy/u8/1080p", 50'000},
                                        {"filter/laplacian/u8/1080p", 40'000},
                                        {"opencv/laplacian/u8/1080p", 320'000}});
    EXPECT_THAT(row(table, "u8 four"), HasSubstr("| 1.25 of copy; **8.00 x OpenCV** | missed |"));
}

TEST(SpeedTable, HoldsWideFiltersAgainstTheirOwnCopy) {
    const std::string table = table_of({{"memcpy/u8/1080p", 50'000},
                                        {"memcpy/u16/1080p", 98'000},
                                        {"filter/laplacian/u16/1080p", 100'000},
                                        {"opencv/laplacian/u16/1080p", 1'500'000},
                                        {"memcpy/f32x4/1080p", 800'000},
                                        {"filter/laplacian/f32x4/1080p", 1'000'000},
                                        {"opencv/laplacian/f32x4/1080p", 6'000'000}});
    EXPECT_THAT(row(table, "u16"), HasSubstr("| 0.98 of copy; 15.0 x OpenCV | met |"));
    EXPECT_THAT(row(table, "4 x f32"), HasSubstr("| **0.80 of copy**; 6.00 x OpenCV | missed |"));
}

TEST(SpeedTable, HasWholeFramesAndTheGainOfTwoThreads) {
    const std::string table = table_of({{"memcpy/u8/1080p", 50'000},
                                        {"frame/mote4/bunny/1080p/threads:1", 380, "us"},
                                        {"frame/mote4/bunny/1080p/threads:2", 200, "us"},
                                        {"frame/mote4/bunny_x16/1080p/threads:1", 2, "ms"},
                                        {"frame/decaudin/bunny/1080p/threads:1", 0.76, "ms"},
                                        {"embree/primary/bunny/1080p/threads:1", 9.5, "ms"},
                                        {"embree/primary/bunny_x16/1080p/threads:1", 1, "ms"}});
    EXPECT_THAT(row(table, "whole frame, `mote4`"), HasSubstr("| 0.38 ms; 25.0 x Embree | met |"));
    EXPECT_THAT(row(table, "the same, bunny subdivided"),
                HasSubstr("| 2.00 ms; **0.50 x Embree** | missed |"));
    EXPECT_THAT(row(table, "two threads, whole frame, bunny"), HasSubstr("| 1.90 x | met |"));
    EXPECT_THAT(row(table, "1998's claim, whole frame"), HasSubstr("| 2.00 x | met |"));
}

TEST(SpeedTable, SaysWhatWasNotRun) {
    const std::string table = table_of({{"memcpy/u8/1080p", 50'000}, {"score/36k", 20, "ms"}});
    EXPECT_THAT(row(table, "the same, dragon"),
                HasSubstr("| not run: `frame/mote4/dragon/1080p/threads:1`, "
                          "`embree/primary/dragon/1080p/threads:1` | not run |"));
    EXPECT_THAT(row(table, "scorer"), HasSubstr("| 20.0 ms | met |"));
}

TEST(SpeedTable, OfNothingHasNoFigure) {
    const std::string table = table_of({});
    EXPECT_THAT(table, Not(HasSubstr("| met |")));
    EXPECT_THAT(table, Not(HasSubstr("| missed |")));
}

TEST(SpeedTable, ReplacesItsBlockInAReadmeAndNothingElse) {
    const Desk desk;
    const std::string json = desk.write("run.json", json_of({{"memcpy/u8/1080p", 50'000}}));
    const std::string readme =
        desk.write("R.md", "before\n<!-- speed -->\nold\n<!-- /speed -->\nafter\n");
    const std::string command = kTable + json + " --readme " + readme;
    const Outcome outcome = run(command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_EQ(desk.read("R.md"),
              "before\n<!-- speed -->\n" + outcome.text + "<!-- /speed -->\nafter\n");
    const std::string once = desk.read("R.md");
    ASSERT_EQ(run(command).exit_code, 0);
    EXPECT_EQ(desk.read("R.md"), once);
}

TEST(SpeedTable, RefusesAFileThatIsNoRunAndAReadmeWithoutItsBlock) {
    const Desk desk;
    const std::string json = desk.write("run.json", json_of({{"memcpy/u8/1080p", 50'000}}));
    const Outcome no_run = run(kTable + desk.write("empty.json", "{}"));
    EXPECT_EQ(no_run.exit_code, 2);
    EXPECT_THAT(no_run.text, AllOf(StartsWith("table.py: "), HasSubstr("no benchmarks in it")));
    const Outcome no_block = run(kTable + json + " --readme " + desk.write("R.md", "nothing"));
    EXPECT_EQ(no_block.exit_code, 2);
    EXPECT_EQ(desk.read("R.md"), "nothing");
    EXPECT_EQ(run(kTable + desk.path("absent.json")).exit_code, 2);
}

}  // namespace
}  // namespace ink::bench_test
