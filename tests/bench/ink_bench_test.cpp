#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/bench/run_command.h"

// ink_bench as a script runs it: flags, the closing table, JSON. No time is judged.

namespace ink::bench_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kBench = "'" INK_BENCH "' --benchmark_min_time=1e-9 ";
const std::string kCopy = "--benchmark_filter='^memcpy/u8/1080p$' ";

TEST(InkBench, ClosesWithLeastMedianYardstickAndHash) {
    const Outcome outcome = run(kBench + kCopy);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_TRUE(
        std::regex_search(outcome.text,
                          std::regex("benchmark +least us +median us +least M +hash of the result\n"
                                     "memcpy/u8/1080p +[0-9.]+ +[0-9.]+ +1\\.00 +[0-9a-f]{16}\n")))
        << outcome.text;
}

TEST(InkBench, WritesRepetitionsMinimumMedianYardstickAndHashToItsFile) {
    const Desk desk;
    const Outcome outcome =
        run(kBench + kCopy + "--benchmark_repetitions=3 --benchmark_out=" + desk.path("o.json"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    const auto report = nlohmann::json::parse(desk.read("o.json"));
    int repetitions = 0;
    std::set<std::string> hashes;
    std::set<std::string> in_m;
    double least = 1e30;
    double minimum = 0;
    for (const auto& entry : report.at("benchmarks")) {
        hashes.insert(entry.at("label").get<std::string>());
        if (entry.at("run_type") == "iteration") {
            ++repetitions;
            least = std::min(least, entry.at("real_time").get<double>());
        } else {
            if (entry.contains("M")) in_m.insert(entry.at("aggregate_name"));
            if (entry.at("aggregate_name") == "min") minimum = entry.at("real_time");
        }
    }
    EXPECT_EQ(repetitions, 3);
    EXPECT_EQ(hashes.size(), 1U);
    EXPECT_EQ(in_m, (std::set<std::string>{"median", "min"}));
    EXPECT_DOUBLE_EQ(minimum, least);
}

TEST(InkBench, RepeatsNineTimesUnlessTold) {
    const auto repetitions_of = [](const std::string& flags) {
        const Outcome outcome = run(kBench + kCopy + "--benchmark_format=json " + flags);
        const std::string found = "\"run_type\": \"iteration\"";
        int count = 0;
        for (auto at = outcome.text.find(found); at != std::string::npos;
             at = outcome.text.find(found, at + 1))
            ++count;
        return count;
    };
    EXPECT_EQ(repetitions_of(""), 9);
    EXPECT_EQ(repetitions_of("--benchmark_repetitions=2"), 2);
}

TEST(InkBench, DrawsExactlySoManyFrames) {
    const std::string one_frame =
        "--benchmark_filter='^frame/mote4/sphere/1080p/threads:1' --benchmark_repetitions=1 ";
    const Outcome outcome = run(kBench + one_frame + "--draws=3 --benchmark_format=json");
    EXPECT_THAT(outcome.text, HasSubstr("\"iterations\": 3,")) << outcome.text;
}

TEST(InkBench, RunsOnTheInstructionSetAskedForAndDrawsTheSame) {
    const std::string one_frame =
        "--benchmark_filter='^frame/mote4/sphere/1080p/threads:1' --benchmark_repetitions=1 ";
    const auto hash_of = [&](const std::string& flags) {
        const Outcome outcome = run(kBench + one_frame + flags);
        std::smatch match;
        EXPECT_TRUE(std::regex_search(outcome.text, match, std::regex("\\b[0-9a-f]{16}\\b")))
            << outcome.text;
        return match.str();
    };
    EXPECT_THAT(run(kBench + kCopy + "--simd=SCALAR").text, HasSubstr("simd: SCALAR"));
    EXPECT_EQ(hash_of("--simd=SCALAR"), hash_of(""));
}

TEST(InkBench, RefusesWhatItDoesNotKnow) {
    const Outcome simd = run(kBench + "--simd=ABACUS");
    EXPECT_EQ(simd.exit_code, 2);
    EXPECT_THAT(simd.text, AllOf(HasSubstr("--simd: 'ABACUS'"), HasSubstr("SCALAR")));
    for (const char* draws : {"0", "-1", "many", "2x", ""}) {
        const Outcome outcome = run(kBench + "--draws=" + draws);
        EXPECT_EQ(outcome.exit_code, 2) << draws;
        EXPECT_THAT(outcome.text, HasSubstr("a whole number from 1 on"));
    }
    EXPECT_EQ(run(kBench + "--nonsense").exit_code, 2);
    EXPECT_EQ(run(kBench + "--benchmark_filter=nonsense").exit_code, 2);
}

TEST(InkBench, TellsOfASingleCore) {
    if (run("taskset -c 0 true").exit_code != 0) GTEST_SKIP() << "core 0 is not ours";
    EXPECT_THAT(run("taskset -c 0 " + kBench + kCopy).text, HasSubstr("one core only"));
}

}  // namespace
}  // namespace ink::bench_test
