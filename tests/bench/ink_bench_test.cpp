#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/program/run_program.h"

// ink_bench as a script runs it: flags, the console, JSON. No time is judged.

namespace ink::bench {
namespace {

using program::Desk;
using program::Outcome;
using program::Words;
using testing::HasSubstr;

const std::string kCopy = "--benchmark_filter=^memcpy/u8/1080p$";
const std::string kFrame = "--benchmark_filter=^frame/mote4/sphere/1080p/threads:1";

Outcome bench(const Desk& desk, Words words) {
    words.insert(words.begin(), "--benchmark_min_time=1e-9");
    return desk.run(words);
}

TEST(InkBench, ShowsMedianAndLeastWithTheHashAndWritesAll) {
    const Desk desk;
    const Outcome outcome =
        bench(desk, {kCopy, "--benchmark_repetitions=3", "--benchmark_out=o.json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    int repetitions = 0;
    double least = 1e30, minimum = 0;
    const auto report = nlohmann::json::parse(desk.read("o.json"));
    for (const auto& entry : report.at("benchmarks")) {
        if (entry.at("run_type") == "iteration") {
            ++repetitions;
            least = std::min(least, entry.at("cpu_time").get<double>());
        } else if (entry.at("aggregate_name") == "min") {
            minimum = entry.at("cpu_time");
            const auto hash = entry.at("label").get<std::string>();
            for (const std::string shown : {"median", "min"})
                EXPECT_TRUE(std::regex_search(
                    outcome.out, std::regex("memcpy/u8/1080p_" + shown + " .* us .*" + hash)))
                    << outcome.out;
        }
    }
    EXPECT_EQ(repetitions, 3);
    EXPECT_NEAR(minimum, least, 1e-9 * least);
}

TEST(InkBench, RepeatsNineTimesUnlessTold) {
    const Desk desk;
    ASSERT_EQ(bench(desk, {kCopy, "--benchmark_out=o.json"}).exit_code, 0);
    const std::string text = desk.read("o.json");
    const std::regex repetition("\"run_type\": \"iteration\"");
    EXPECT_EQ(std::distance(std::sregex_iterator(text.begin(), text.end(), repetition), {}), 9);
}

TEST(InkBench, DrawsExactlySoManyFramesAndTheSameOnTheInstructionSetAskedFor) {
    const auto hash_of = [](const std::string& simd) {
        const Desk desk;
        const Outcome outcome = bench(
            desk,
            {kFrame, "--benchmark_repetitions=1", "--draws=3", "--benchmark_out=o.json", simd});
        EXPECT_THAT(desk.read("o.json"), HasSubstr("\"iterations\": 3,"));
        if (simd.ends_with("SCALAR")) {
            EXPECT_THAT(outcome.err, HasSubstr("simd: SCALAR"));
        }
        std::smatch match;
        EXPECT_TRUE(std::regex_search(outcome.out, match, std::regex("\\b[0-9a-f]{16}\\b")));
        return match.str();
    };
    EXPECT_EQ(hash_of("--simd=SCALAR"), hash_of("--draws=3"));
}

TEST(InkBench, RefusesWhatItDoesNotKnow) {
    const Desk desk;
    for (const auto& [flag, said] : {std::pair{"--simd=ABACUS", "--simd: 'ABACUS'"},
                                     {"--simd=ABACUS", "SCALAR"},
                                     {"--draws=0", "a whole number from 1 on"},
                                     {"--draws=-1", "a whole number from 1 on"},
                                     {"--draws=many", "a whole number from 1 on"},
                                     {"--draws=2x", "a whole number from 1 on"},
                                     {"--draws=", "a whole number from 1 on"},
                                     {"--benchmark_format=json", "--benchmark_out=FILE"},
                                     {"--nonsense", ""},
                                     {"--benchmark_filter=nonsense", ""}}) {
        const Outcome outcome = bench(desk, {flag});
        EXPECT_EQ(outcome.exit_code, 2) << flag;
        EXPECT_THAT(outcome.out + outcome.err, HasSubstr(said)) << flag;
    }
}

TEST(InkBench, TellsOfASingleCore) {
    const Desk desk;
    const Words alone = {"-c", "0", INK_PROGRAM, "--benchmark_min_time=1e-9", kCopy};
    const Outcome outcome = desk.run_other("/usr/bin/taskset", alone);
    if (outcome.exit_code != 0) GTEST_SKIP() << "skipped: core 0 is not ours";
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("one core only"));
}

}  // namespace
}  // namespace ink::bench
