#include <fmt/format.h>
#include <gmock/gmock.h>

#include <vector>

#include "tests/program/run_program.h"

// bench/table.py and bench/callgrind.py on times and profiles that are made up, so that every
// figure can be worked out by hand.

namespace ink::bench {
namespace {

using program::Desk;
using program::Outcome;
using program::Words;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Times_us = std::vector<std::pair<const char*, double>>;

/// What ink_bench would have written: each benchmark twice, the second time slower by a half, and
/// an aggregate that must not be taken for a time.
std::string json_of(const Times_us& times) {
    std::string entries;
    for (const auto& [name, time_us] : times) {
        // One thread may wait; two may share the work unevenly.
        const bool is_alone = std::string_view(name).find("/threads:2") == std::string::npos;
        for (const auto& [type, value] :
             {std::pair{"iteration", time_us}, {"iteration", 1.5 * time_us}, {"aggregate", 1e-3}})
            entries +=
                fmt::format(R"({}{{"run_name": "{}", "run_type": "{}", "aggregate_name": "cv",)"
                            R"( "real_time": {}, "cpu_time": {}, "time_unit": "us"}})",
                            entries.empty() ? "" : ", ",
                            name,
                            type,
                            is_alone ? 7 * value : value,
                            is_alone ? value : 0.1 * value);
    }
    return R"({"context": {"cpu": "made up"}, "benchmarks": [)" + entries + "]}";
}

Outcome table(const Desk& desk, Words words) {
    words.insert(words.begin(), INK_SOURCE_DIR "/bench/table.py");
    return desk.run_other("/usr/bin/python3", words);
}

std::string table_of(const Times_us& times) {
    const Desk desk;
    const Outcome outcome = table(desk, {desk.write("run.json", json_of(times))});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
}

TEST(SpeedTable, GivesRatiosOfLeastTimesAndMarksWhatIsMissed) {
    EXPECT_THAT(
        table_of({{"memcpy/u8/1080p", 50},
                  {"filter/laplacian/u8/1080p", 40},
                  {"opencv/laplacian/u8/1080p", 400},
                  {"memcpy/f32x4/1080p", 800},
                  {"filter/laplacian/f32x4/1080p", 1000},
                  {"opencv/laplacian/f32x4/1080p", 6000},
                  {"frame/mote4/dragon_coarse/1080p/threads:1", 380},
                  {"frame/mote4/dragon_coarse/1080p/threads:2", 200},
                  {"frame/mote4/dragon/1080p/threads:1", 2000},
                  {"embree/primary/dragon_coarse/1080p/threads:1", 9500},
                  {"embree/primary/dragon/1080p/threads:1", 1000}}),
        AllOf(HasSubstr("Least of 2 or more interleaved repetitions, made up"),
              HasSubstr(
                  "| u8 four-neighbour Laplacian, scale, clip | a copy of as many bytes, OpenCV "
                  "| >= 9 x OpenCV | 1.25 of copy; 10.0 x OpenCV | met |"),
              HasSubstr("| **0.80 of copy**; 6.00 x OpenCV | missed |"),
              HasSubstr("| 0.38 ms; 25.0 x Embree | met |"),
              HasSubstr("| 2.00 ms; **0.50 x Embree** | missed |"),
              HasSubstr("| 1.90 x | met |")));
}

TEST(SpeedTable, SaysWhatWasNotRun) {
    EXPECT_THAT(table_of({{"memcpy/u8/1080p", 50}, {"score/36k", 20000}}),
                AllOf(HasSubstr("| not run: `frame/mote4/dragon/1080p/threads:1`, "
                                "`embree/primary/dragon/1080p/threads:1` | not run |"),
                      HasSubstr("| 20.0 ms | met |")));
    EXPECT_THAT(table_of({}), AllOf(Not(HasSubstr("| met |")), Not(HasSubstr("| missed |"))));
}

TEST(SpeedTable, ReplacesItsBlockInAReadmeAndNothingElse) {
    const Desk desk;
    const std::string json = desk.write("run.json", json_of({{"memcpy/u8/1080p", 50}}));
    desk.write("R.md", "before\n<!-- speed -->\nold\n<!-- /speed -->\nafter\n");
    for (int time = 0; time < 2; ++time) {
        const Outcome outcome = table(desk, {json, "--readme", "R.md"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(desk.read("R.md"),
                  "before\n<!-- speed -->\n" + outcome.out + "<!-- /speed -->\nafter\n");
    }
    EXPECT_EQ(table(desk, {json, "--readme", desk.write("bare.md", "nothing")}).exit_code, 2);
    EXPECT_EQ(desk.read("bare.md"), "nothing");
    EXPECT_EQ(table(desk, {"absent.json"}).exit_code, 2);
    const Outcome no_run = table(desk, {desk.write("empty.json", "{}")});
    EXPECT_EQ(no_run.exit_code, 2);
    EXPECT_THAT(no_run.err, AllOf(StartsWith("table.py: "), HasSubstr("no benchmarks in it")));
}

/// A valgrind that says what it counted by the benchmark and the number of draws asked for.
constexpr const char* kValgrind = R"(#!/bin/sh
for word in "$@"; do
    case $word in
        --callgrind-out-file=*) profile=${word#*=} ;;
        --benchmark_out=*) report=${word#*=} ;;
        --benchmark_filter=*) benchmark=${word#*=} ;;
        --draws=*) draws=${word#*=} ;;
    esac
done
case $benchmark in
    *laplacian/u8*) cat > "$profile" <<'END'
events: Ir
fn=(1) ink::edge::laplacian(ink::core::ImageView<unsigned char const> const&, int)
12 2073600
cfn=(2) ink::edge::N_AVX2::row()
calls=2 40
13 6220800

fn=(2)
40 6220800

fn=(3) ink::bench::time_laplacian()
cfn=(1)
calls=2 12
7 8294400
END
    ;;
    *frame/mote4/dragon_coarse*) cat > "$profile" <<END
events: Ir
fn=(1) ink::raster::fill_tile<ink::raster::SetupTriangle>()
1 $((1000000 + draws * 4147200))
fn=(2) ink::raster::set_up(ink::raster::FillJob const&)
1 $((77 + draws * 500))
fn=(3) ink::scene::flatten()
1 999
fn=(4) ink::bench::wake_worker()
1 $((draws * 123456))
END
    ;;
    *) echo "Failed to match any benchmarks against regex: $benchmark" >&2; exit 2 ;;
esac
echo '{"benchmarks": [{"triangles": 100, "vertices": 50}]}' > "$report"
)";

std::string counted(const std::string& flags = "") {
    const Desk desk;
    desk.write("valgrind", kValgrind);
    const Outcome outcome = desk.run_other(
        "/bin/sh",
        {"-c",
         "chmod +x valgrind; PATH=.:$PATH python3 " INK_SOURCE_DIR "/bench/callgrind.py " + flags});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out + outcome.err;
}

TEST(Callgrind, CountsAPixelsWorkAndStagesByTheDifferenceOfDraws) {
    const std::string frame = " | `frame/mote4/dragon_coarse/1080p/threads:1` | ";
    EXPECT_THAT(counted(),
                AllOf(HasSubstr("| Laplacian, u8 | `filter/laplacian/u8/1080p` | pixel | 2.00 |\n"),
                      HasSubstr("| whole frame" + frame + "pixel | 2.00 |\n"),
                      HasSubstr("| fill, 100 % of the frame" + frame + "pixel | 2.00 |\n"),
                      HasSubstr("| setup, 0 % of the frame" + frame + "triangle | 5.00 |\n"),
                      HasSubstr("| vertices: place and values, 0 % of the frame" + frame +
                                "vertex | 0.00 |\n"),
                      HasSubstr("| `filter/decaudin/1080p` | pixel | not run |"),
                      Not(HasSubstr("the rest"))));
    EXPECT_THAT(counted("--functions --mesh dragon"),
                HasSubstr("| `frame/mote4/dragon/1080p/threads:1` | pixel | not run |"));
    EXPECT_THAT(counted("--functions"), HasSubstr("fill_tile"));
}

}  // namespace
}  // namespace ink::bench
