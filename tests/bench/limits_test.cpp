#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/run_command.h"

// bench/limits.py with a prototype and an ink_bench that are made up. No time is judged.

namespace ink::bench_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Prints the rows that the script reads; each takes twice its median at least.
constexpr const char* kPrototype = R"(#!/bin/sh
echo "## prototype limit, made up"
echo "cull                                             0.2000     0.1000         -   1.0 1.0"
echo "cull + transform                                 0.6000     0.3000         -   1.0 1.0"
echo "cull + transform + setup                         1.2000     0.6000         -   1.0 1.0"
echo "depth32 + u8 G-buffer                            1.8000     0.9000         -   1.0 1.0"
echo "whole frame: depth32 + u8 + Laplacian            2.0000     1.0000         -   1.0 1.0"
)";

/// Writes one mesh; every stage takes half a millisecond more than the one before, every method 3.
constexpr const char* kBench = R"(#!/usr/bin/python3
import json, sys
for word in sys.argv[1:]:
    if word.startswith("--write-meshes="):
        open(word.split("=", 1)[1] + "/cube.obj", "w").close()
        sys.exit(0)
    if word.startswith("--benchmark_filter="):
        names = word.split("=", 1)[1][2:-2].split("|")
stages = ["cull", "transform", "lists", "setup", "fill", "edges"]
def ms(name):
    stage = name.split("/")[1]
    if stage in stages:
        return 0.5 * (1 + stages.index(stage))
    return 1.5 if name.endswith("threads:2") else 3.0
print(json.dumps({"benchmarks": [{"run_name": n, "run_type": "iteration", "real_time": ms(n),
    "time_unit": "ms", "triangles": 12000} for n in names]}))
)";

Outcome limits(const Desk& desk, const std::string& flags) {
    const std::string bench = desk.write("bench.py", kBench);
    return run("chmod +x " + bench + " && python3 " INK_SOURCE_DIR "/bench/limits.py --rounds 1 " +
               "--program " + bench + " " + flags + " 2>/dev/null");
}

std::string prototype(const Desk& desk) {
    const std::string program = desk.write("raster_limits", kPrototype);
    EXPECT_EQ(run("chmod +x " + program).exit_code, 0);
    return program;
}

TEST(Limits, GivesFramesAndStagesInFramesOfThePrototype) {
    const Desk desk;
    const Outcome outcome = limits(desk, prototype(desk));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("| `cube` | 12 k | 1.00 | 3.00 | 1.00 | 1.00 | 1.00 | "));
    EXPECT_THAT(outcome.text,
                HasSubstr("| `cube` | prototype | 0.10 | 0.20 | - | 0.30 | 0.30 | 0.10 | 1.00 |"));
    EXPECT_THAT(outcome.text,
                HasSubstr("| `cube` | fronts, flat | 0.50 | 0.50 | 0.50 | 0.50 | 0.50 | 0.50 | "
                          "3.00 |"));
}

TEST(Limits, SaysWhatToDoWithoutThePrototype) {
    const Desk desk;
    const Outcome outcome =
        run("python3 " INK_SOURCE_DIR "/bench/limits.py " + desk.path("absent.cpp"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.text,
                AllOf(StartsWith("limits.py: "),
                      HasSubstr("absent.cpp: no such file"),
                      HasSubstr("accepted: raster_limits.cpp")));
}

TEST(Limits, RefusesAMeshThatItDoesNotHave) {
    const Desk desk;
    EXPECT_EQ(limits(desk, prototype(desk) + " --mesh teapot").exit_code, 2);
    EXPECT_EQ(limits(desk, prototype(desk) + " --mesh cube").exit_code, 0);
}

}  // namespace
}  // namespace ink::bench_test
