#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/run_command.h"

// bench/callgrind.py on profiles that are made up: a `valgrind` of ours writes them.

namespace ink::bench_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Says what it counted by the benchmark and the number of draws that it was asked for.
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
    *frame/mote4/bunny*) cat > "$profile" <<END
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
    const std::string valgrind = desk.write("valgrind", kValgrind);
    const Outcome outcome = run("chmod +x " + valgrind + " && PATH=" + desk.path("") +
                                ":$PATH python3 " INK_SOURCE_DIR "/bench/callgrind.py " + flags);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    return outcome.text;
}

TEST(Callgrind, DividesAFilterWithAllItCallsByItsPixels) {
    EXPECT_THAT(counted(),
                HasSubstr("| Laplacian, u8 | `filter/laplacian/u8/1080p` | pixel | 2.00 |\n"));
}

TEST(Callgrind, TakesStagesFromTheDifferenceOfDraws) {
    const std::string table = counted();
    const std::string frame = " | `frame/mote4/bunny/1080p/threads:1` | ";
    EXPECT_THAT(table, HasSubstr("| whole frame" + frame + "pixel | 2.00 |\n"));
    EXPECT_THAT(table, HasSubstr("| fill, 100 % of the frame" + frame + "pixel | 2.00 |\n"));
    EXPECT_THAT(table, HasSubstr("| setup, 0 % of the frame" + frame + "triangle | 5.00 |\n"));
    EXPECT_THAT(
        table,
        HasSubstr("| vertices: place and values, 0 % of the frame" + frame + "vertex | 0.00 |\n"));
    EXPECT_THAT(table, Not(HasSubstr("the rest")));
}

TEST(Callgrind, ListsFunctionsOnRequest) {
    EXPECT_THAT(counted("--functions"), HasSubstr("fill_tile"));
}

TEST(Callgrind, SaysWhatWasNotRun) {
    EXPECT_THAT(counted(), HasSubstr("| `filter/decaudin/1080p` | pixel | not run |"));
    EXPECT_THAT(
        counted("--mesh dragon"),
        HasSubstr("| whole frame | `frame/mote4/dragon/1080p/threads:1` | pixel | not run |"));
}

}  // namespace
}  // namespace ink::bench_test
