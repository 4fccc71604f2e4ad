// The tuner as a user runs it: killed, gone on, and to the same bytes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;

std::vector<std::string> tune_words(const std::string& out) {
    return {"tune",
            "mote4",
            "--scenes",
            "cube,layers,gem",
            "--size",
            "160x90",
            "--seed",
            "3",
            "--cache",
            "cache",
            "--out",
            out,
            "--evaluations",
            "40"};
}

long lines_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
}

/// Runs the program and kills it, without a word of warning, when its log has `lines` lines.
void run_and_kill(const Desk& desk, const std::vector<std::string>& words, long lines) {
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> arguments = {const_cast<char*>(INK_PROGRAM)};
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (chdir(desk.work().c_str()) == 0) execv(INK_PROGRAM, arguments.data());
        _exit(127);
    }
    const auto log = desk.work() / "killed" / "evaluations.csv.part";
    int status = 0;
    while (lines_of(log) < lines && waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
}

TEST(TuneProgram, KilledAndStartedAgainItComesToTheSameBytes) {
    const Desk desk;
    const Outcome whole = desk.run(tune_words("whole"));
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    for (const long lines : {3, 11, 47})
        run_and_kill(desk, tune_words("killed"), lines);
    const Outcome last = desk.run(tune_words("killed"));
    ASSERT_EQ(last.exit_code, 0) << last.err;
    for (const char* file : {"/evaluations.csv", "/mote4_tuned.toml"}) {
        EXPECT_EQ(desk.read("killed" + std::string(file)), desk.read("whole" + std::string(file)));
    }
    EXPECT_EQ(parse_csv(desk.read("whole/evaluations.csv")).size(), 80U);
    EXPECT_FALSE(std::filesystem::exists(desk.work() / "killed" / "evaluations.csv.part"));
}

TEST(TuneProgram, CtrlCKeepsWhatIsFinishedAndSaysHowToGoOn) {
    const Desk desk;
    std::vector<std::string> words = tune_words("out");
    words.back() = "100000";
    const auto log = desk.work() / "out" / "evaluations.csv.part";
    const Outcome stopped = desk.run_until(words, [&] { return lines_of(log) > 5; });
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_THAT(stopped.err, HasSubstr("the same command goes on from there"));
    EXPECT_GT(lines_of(log), 5);
    EXPECT_FALSE(std::filesystem::exists(desk.work() / "out" / "mote4_tuned.toml"));
}

TEST(TuneProgram, SaysWhatWasFoundAndItsPresetCanBeUsed) {
    const Desk desk;
    std::vector<std::string> words = tune_words("out");
    words.insert(words.end(), {"--name", "mine"});
    const Outcome tuned = desk.run(words);
    ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
    for (const char* word : {"E train",
                             "unseen",
                             "gap",
                             "95 %",
                             "random search",
                             "paired difference of mine",
                             "range_depth",
                             "out/mine.toml"}) {
        EXPECT_THAT(tuned.out, HasSubstr(word));
    }
    EXPECT_THAT(desk.read("out/mine.toml"),
                HasSubstr("command = \"inkbench tune mote4 --evaluations 40 --seed 3 --scenes "
                          "cube,layers,gem --size 160x90 --name mine\""));

    const Outcome drawn = desk.run(
        {"draw", "cube", "--size", "64x36", "--preset", "out/mine.toml", "-o", "cube.png"});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    const Outcome compared = desk.run({"compare",
                                       "--scenes",
                                       "cube",
                                       "--size",
                                       "64x36",
                                       "--methods",
                                       "mote4",
                                       "--preset",
                                       "out/mine.toml",
                                       "--no-sweep",
                                       "--repetitions",
                                       "1",
                                       "--out",
                                       "compared",
                                       "--cache",
                                       "cache"});
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_THAT(desk.read("compared/rows.csv"), HasSubstr(",compare,,,mine,cube,"));
}

TEST(TuneProgram, BadInputIsExplained) {
    const Desk desk;
    const auto refused = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "tune");
        const Outcome outcome = desk.run(words);
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    EXPECT_THAT(refused({"mote5"}), HasSubstr("mote4"));
    EXPECT_THAT(refused({"mote4", "--objective", "speed"}), HasSubstr("error, scenes, ap"));
    EXPECT_THAT(refused({"mote4", "--params", "range"}), HasSubstr("range_nx"));
    EXPECT_THAT(refused({"mote4", "--global", "luck"}), HasSubstr("crs, direct, esch"));
    EXPECT_THAT(refused({"mote4", "--evaluations", "0"}), HasSubstr("1..1000000"));
    EXPECT_THAT(refused({"mote4", "--budget-ms", "0"}), HasSubstr("above 0"));
    EXPECT_THAT(refused({"mote4", "--name", "A b"}), HasSubstr("small letters"));
    EXPECT_THAT(refused({"mote4", "--scenes", "gem"}), HasSubstr("training"));
    desk.write("bad.toml", "name = \"x\"\nmethod = \"mote4\"\n[settings]\nthreshold = 0\n");
    const Outcome bad = desk.run({"draw", "cube", "--preset", "bad.toml", "-o", "a.png"});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err, HasSubstr("bad.toml:4: parameter threshold cannot be '0'"));
}

}  // namespace
}  // namespace ink::program
