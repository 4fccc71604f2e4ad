#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "tests/program/run_program.h"

// Experiments as a user runs them: killed, resumed, shared out, interrupted.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

constexpr const char* kExperiment = R"(name = "tiny"
kind = "compare"
seed = 3
[grid]
scenes = ["cube", "rocket", "letters", "tiles"]
views = 2
methods = ["mote4", "ids", "edge_list"]
sizes = ["96x54"]
[measure]
repetitions = 1
times = false
[sweep.mote4]
threshold = [3, 6, 12]
range_depth = [31, 63]
)";

const Words kTables =
    "rows.csv curves.csv bins.csv tolerances.csv cancellation.csv sweep.csv cost.csv methods.csv "
    "summary.csv images/cube/front/truth.png images/cube/front/mote4.png "
    "images/cube/front/mote4.errors.png";

/// All tables of a folder, one behind the other.
std::string tables_of(const Desk& desk, const std::string& folder) {
    std::string text;
    for (const std::string& table : kTables) {
        const std::string one = desk.read(folder + "/" + table);
        EXPECT_NE(one, "") << folder << "/" << table;
        text += table + "\n" + one;
    }
    return text;
}

TEST(Run, SaysHowMuchThereIsToDoAndWritesTables) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    const Outcome outcome = desk.run({"run", "tiny.toml"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // 4 scenes x 2 views x (3 methods + 4 baselines + 6 settings), a block for rows and one for the
    // sweep on each view.
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("tiny: 96 cells in 16 blocks"), HasSubstr("about")));
    EXPECT_THAT(outcome.out, HasSubstr("report.html"));
    const Table rows = rows_of(desk, "inkbench-out/tiny");
    EXPECT_EQ(rows.size(), 56U);
    EXPECT_EQ(parse_csv(desk.read("inkbench-out/tiny/sweep.csv")).size(), 48U);
    for (const auto& row : rows) {
        EXPECT_EQ(row.at("status"), "ok");
        EXPECT_EQ(row.at("seed"), "3");
        EXPECT_EQ(row.at("draw_ns") + row.at("draw_n"), "");
    }
    EXPECT_THAT(desk.run({"run", "tiny.toml"}).err, HasSubstr("all 96 cells are done"));
}

constexpr const char* kOwnCameras = R"(name = "cameras"
kind = "compare"
[grid]
scenes = ["gear"]
methods = ["ids", "mote4"]
sizes = ["96x54"]
[measure]
times = false
[views]
cameras = [{eye = [3, 2, 5], target = [0.1, 0, 0], up = [0, 1, 0.5], fov_deg = 35},
           {eye = [1, 2, 6], parallel_height = 2.5}]
time_s = 0.25
[settings]
mote4.fatten = true
)";

/// Every file of a folder but the page, which names the folder, and run.toml, which has the
/// command and how long it took.
std::map<std::string, std::string> results_in(const Desk& desk, const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(desk.work() / folder)) {
        const std::string name = entry.path().lexically_relative(desk.work() / folder);
        if (entry.is_regular_file() && name != "report.html" && name != "run.toml")
            files[name] = desk.read(folder + "/" + name);
    }
    return files;
}

TEST(Run, FromWhatRunTomlRecordsGivesTheSameBytes) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    desk.write("cameras.toml", kOwnCameras);
    const Words small = " --methods ids --size 64x36 --no-times ";
    const std::vector<Words> commands = {
        "run cameras.toml",
        "run tiny.toml --scenes cube --size 64x36",
        "compare cube --no-sweep --eye 1,2,6 --parallel 3 --antialias resolve4 --set threshold=90" +
            small,
        "compare cube --no-sweep --views front,iso --fit box --margin 0.1" + small,
        "stress --axes origin --points 2 --coverage --antialias none,resolve4" + small};
    for (const Words& command : commands) {
        SCOPED_TRACE(testing::PrintToString(command));
        expect_done(desk, command + "--force --out first");
        expect_done(desk, "run first/run.toml --force --out again");
        const auto first = results_in(desk, "first");
        EXPECT_EQ(first, results_in(desk, "again"));
        EXPECT_GT(first.size(), 4U);
        EXPECT_TRUE(first.contains("rows.csv"));
    }
}

TEST(Run, KilledTwentyTimesAtRandomMomentsGivesTheBytesOfAnUndisturbedRun) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    const auto begin = Clock::now();
    expect_done(desk, "run tiny.toml --out whole");
    const auto whole = Clock::now() - begin;
    const std::string expected = tables_of(desk, "whole");

    std::mt19937 random(20);
    std::uniform_real_distribution<double> share(0.05, 1.0);
    int kills = 0;
    int finished = 0;
    while (kills < 20) {
        const std::string folder = "run" + std::to_string(finished);
        const Words words = "run tiny.toml --out " + folder;
        const auto deadline = Clock::now() + whole * share(random);
        const Outcome outcome = desk.kill_when(words, [&] { return Clock::now() >= deadline; });
        if (outcome.exit_code == 128 + 9) {
            ++kills;
            continue;
        }
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(tables_of(desk, folder), expected) << folder;
        ++finished;
    }
    const std::string folder = "run" + std::to_string(finished);
    expect_done(desk, "run tiny.toml --out " + folder);
    EXPECT_EQ(tables_of(desk, folder), expected);
    std::set<std::string> left;
    for (const auto& [name, size] : desk.inventory())
        if (name.find(".part") != std::string::npos) left.insert(name);
    EXPECT_TRUE(left.empty()) << testing::PrintToString(left);
}

TEST(Run, ShardsMergedGiveTheBytesOfOneRun) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    expect_done(desk, "run tiny.toml --out whole");
    for (const char* part : {"--shard 3/3 --out part3", "--shard 1/3 --out part1"}) {
        const Outcome outcome = desk.run("run tiny.toml" + Words(part));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("of 96 cells"));
        EXPECT_THAT(outcome.out, HasSubstr("inkbench merge"));
    }
    EXPECT_THAT(refusal(desk, "merge part1 part3 -o merged"), HasSubstr("blocks are missing"));
    expect_done(desk, "run tiny.toml --shard 2/3 --out part2");
    expect_done(desk, "merge part3 part1 part2 -o merged");
    EXPECT_EQ(tables_of(desk, "merged"), tables_of(desk, "whole"));
}

TEST(Run, InterruptedKeepsWhatIsFinishedAndGoesOn) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    // Blocks end in any order where several scenes are at work.
    const Outcome outcome = desk.run_until("run tiny.toml --out a", [&] {
        const std::filesystem::path blocks = desk.work() / "a/blocks";
        if (!std::filesystem::exists(blocks)) return false;
        const auto is_done = [](const auto& entry) {
            return std::filesystem::exists(entry.path() / "block.toml");
        };
        const auto done = std::count_if(std::filesystem::directory_iterator(blocks),
                                        std::filesystem::directory_iterator(),
                                        is_done);
        return done >= 2;
    });
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("parts are missing"), HasSubstr("goes on")));
    const auto record = page_data(desk.read("a/report.html"))["runs"][0]["record"];
    EXPECT_EQ(record["state"], "unfinished");
    EXPECT_FALSE(record["missing_blocks"].empty());
    EXPECT_THAT(desk.read("a/run.toml"), HasSubstr("unfinished"));
    const Outcome next = desk.run("run tiny.toml --out a");
    EXPECT_EQ(next.exit_code, 0);
    EXPECT_THAT(next.err, HasSubstr("cells done, about"));
    expect_done(desk, "run tiny.toml --out b");
    EXPECT_EQ(tables_of(desk, "a"), tables_of(desk, "b"));
}

TEST(Run, RefusesBadInputWithOneLineAndExitTwo) {
    const Desk desk;
    desk.write("tiny.toml", kExperiment);
    desk.write("bad.toml", "name = \"bad\"\nkind = \"compare\"\n[grid]\nscenes = [\"cubes\"]\n");
    desk.write("file", "");
    expect_all_refused(desk,
                       "run",
                       {{"bad.toml", "bad.toml:4"},
                        {"nothing.toml", "nothing.toml"},
                        {"tiny.toml --shard 4/3", "--shard"},
                        {"tiny.toml --size big", "--size"},
                        {"tiny.toml --methods mote5", "mote5"},
                        {"tiny.toml --out file/x", "file/x"}});
    expect_refused(desk, "merge nowhere -o merged", "nowhere");

    expect_done(desk, "run tiny.toml --scenes cube --views 1");
    expect_refused(desk, "run tiny.toml", {"another run"});
    expect_done(desk, "run tiny.toml --scenes tiles --views 1 --force");
}

}  // namespace
}  // namespace ink::program
