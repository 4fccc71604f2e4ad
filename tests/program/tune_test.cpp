// The tuner as a user runs it: killed, gone on, and to the same bytes.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>

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

TEST(TuneProgram, KilledAndStartedAgainItComesToTheSameBytes) {
    const Desk desk;
    expect_done(desk, tune_words("whole"));
    const auto log = desk.work() / "killed" / "evaluations.csv.part";
    for (const long lines : {3, 11, 47})
        (void)desk.kill_when(tune_words("killed"), [&] { return lines_of(log) >= lines; });
    expect_done(desk, tune_words("killed"));
    for (const char* file : {"/evaluations.csv", "/mote4_cube_layers_gem.toml"})
        EXPECT_EQ(desk.read("killed" + std::string(file)), desk.read("whole" + std::string(file)));
    EXPECT_EQ(parse_csv(desk.read("whole/evaluations.csv")).size(), 80U);
    EXPECT_FALSE(std::filesystem::exists(log));
}

TEST(TuneProgram, SaysWhatWasFoundAndItsPresetCanBeUsed) {
    const Desk desk;
    const std::string out = expect_done(desk, tune_words("out") + "--name mine");
    for (const std::string& word : Words("unseen gap range_depth out/mine.toml") +
                                       Words{"E train", "interval of E", "random search"} +
                                       Words{"paired difference of mine"})
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
    expect_refused(desk, "tune mote5", "mote4");
    expect_all_refused(desk,
                       "tune mote4",
                       {{"--objective speed", {"pooled | scenes | kinds | worst | even"}},
                        {"--params range", "range_nx"},
                        {"--global luck", {"crs | direct"}},
                        {"--evaluations 0", "1..1000000"},
                        {"--budget-ms 0", {"above 0"}},
                        {{"--name", "A b"}, {"small letters"}},
                        {"--scenes gem", "training"}});
    desk.write("bad.toml", "name = \"x\"\nmethod = \"mote4\"\n[settings]\nthreshold = 0\n");
    expect_refused(desk,
                   "draw cube --preset bad.toml -o a.png",
                   {"bad.toml:4: parameter threshold cannot be '0'"});
}

}  // namespace
}  // namespace ink::program
