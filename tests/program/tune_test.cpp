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

Words tune_words(const std::string& out) {
    return fmt::format(
        "tune mote4 --scenes cube,layers,gem --size 160x90 --seed 3 --cache cache --out {} "
        "--evaluations 40",
        out);
}

long lines_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
}

/// Runs the program and kills it, without a word of warning, when its log has `lines` lines.
void run_and_kill(const Desk& desk, const Words& words, long lines) {
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
    expect_done(desk, tune_words("whole"));
    for (const long lines : {3, 11, 47})
        run_and_kill(desk, tune_words("killed"), lines);
    expect_done(desk, tune_words("killed"));
    for (const char* file : {"/evaluations.csv", "/mote4_tuned.toml"}) {
        EXPECT_EQ(desk.read("killed" + std::string(file)), desk.read("whole" + std::string(file)));
    }
    EXPECT_EQ(parse_csv(desk.read("whole/evaluations.csv")).size(), 80U);
    EXPECT_FALSE(std::filesystem::exists(desk.work() / "killed" / "evaluations.csv.part"));
}

TEST(TuneProgram, CtrlCKeepsWhatIsFinishedAndSaysHowToGoOn) {
    const Desk desk;
    Words words = tune_words("out");
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
    const std::string out = expect_done(desk, tune_words("out") + "--name mine");
    for (const char* word : {"E train",
                             "unseen",
                             "gap",
                             "95 %",
                             "random search",
                             "paired difference of mine",
                             "range_depth",
                             "out/mine.toml"})
        EXPECT_THAT(out, HasSubstr(word));
    EXPECT_THAT(desk.read("out/mine.toml"),
                HasSubstr("command = \"inkbench tune mote4 --evaluations 40 --seed 3 --scenes "
                          "cube,layers,gem --size 160x90 --name mine\""));

    expect_done(desk, "draw cube --size 64x36 --preset out/mine.toml -o cube.png");
    expect_done(desk,
                "compare --scenes cube --size 64x36 --methods mote4 --preset out/mine.toml "
                "--no-sweep --repetitions 1 --out compared --cache cache");
    EXPECT_THAT(desk.read("compared/rows.csv"), HasSubstr(",compare,,,mine,cube,"));
}

TEST(TuneProgram, BadInputIsExplained) {
    const Desk desk;
    EXPECT_THAT(refusal(desk, "tune mote5"), HasSubstr("mote4"));
    EXPECT_THAT(refusal(desk, "tune mote4 --objective speed"),
                HasSubstr("pooled | scenes | kinds | worst | even | ap"));
    EXPECT_THAT(refusal(desk, "tune mote4 --params range"), HasSubstr("range_nx"));
    EXPECT_THAT(refusal(desk, "tune mote4 --global luck"), HasSubstr("crs | direct | esch"));
    EXPECT_THAT(refusal(desk, "tune mote4 --evaluations 0"), HasSubstr("1..1000000"));
    EXPECT_THAT(refusal(desk, "tune mote4 --budget-ms 0"), HasSubstr("above 0"));
    EXPECT_THAT(refusal(desk, {"tune", "mote4", "--name", "A b"}), HasSubstr("small letters"));
    EXPECT_THAT(refusal(desk, "tune mote4 --scenes gem"), HasSubstr("training"));
    desk.write("bad.toml", "name = \"x\"\nmethod = \"mote4\"\n[settings]\nthreshold = 0\n");
    EXPECT_THAT(refusal(desk, "draw cube --preset bad.toml -o a.png"),
                HasSubstr("bad.toml:4: parameter threshold cannot be '0'"));
}

}  // namespace
}  // namespace ink::program
