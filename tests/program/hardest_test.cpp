#include <fmt/format.h>
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

Words small_search(const std::string& out) {
    return fmt::format(
        "stress --hardest mote4 --against ids --scenes rocket,staircase,gear --evaluations 30 "
        "--least-truth 40 --worst 2 --size 128x72 --seed 3 --no-cache --out {}",
        out);
}

/// What must be the same however often the run was killed.
std::string bytes_of(const Desk& desk, const std::string& folder) {
    std::string text;
    for (const char* name : {"hardest.csv", "rows.csv", "curves.csv", "bins.csv"}) {
        const std::string one = desk.read(folder + "/" + name);
        EXPECT_NE(one, "") << folder << "/" << name;
        text += one;
    }
    return text;
}

TEST(Hardest, WritesRowsOfTheWorstViewsAndAPage) {
    const Desk desk;
    const std::string out = expect_done(desk, small_search("out"));
    const Table looks = parse_csv(desk.read("out/hardest.csv"));
    Table kept;
    for (const auto& look : looks)
        if (!look.at("rank").empty()) kept.push_back(look);
    ASSERT_FALSE(kept.empty());
    const Table rows = rows_of(desk);
    EXPECT_EQ(rows.size(), kept.size() * 6) << "two methods and four baselines";
    for (const auto& look : kept) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) {
            return one.at("scene") == look.at("shown_as") && one.at("view") == look.at("view") &&
                   one.at("method") == "mote4";
        });
        ASSERT_NE(row, rows.end()) << look.at("shown_as") << look.at("view");
        EXPECT_EQ(row->at("f_2px"), look.at("f_2px"));
        EXPECT_EQ(row->at("n_truth"), look.at("n_truth"));
        EXPECT_TRUE(std::filesystem::is_regular_file(
            desk.work() / "out/images" / look.at("shown_as") / look.at("view") / "mote4.png"));
    }
    EXPECT_THAT(out, HasSubstr("F least"));
    EXPECT_FALSE(std::filesystem::exists(desk.work() / "out/verdict.md"));
    EXPECT_EQ(page_table(desk, "out", "hardest.csv")["lines"], looks.size());
}

TEST(Hardest, WithCoverageIsWhereMostInkIsLost) {
    const Desk desk;
    const std::string out =
        expect_done(desk,
                    "stress --hardest strokes --scenes rocket --evaluations 12 --size 128x72 "
                    "--least-truth 40 --worst 1 --coverage --line-width 1 --out out");
    EXPECT_THAT(out, HasSubstr("soft F least"));
    const auto rows = only(rows_of(desk), "strokes");
    ASSERT_EQ(rows.size(), 1U);
    for (const auto& look : parse_csv(desk.read("out/hardest.csv"))) {
        if (look.at("status") == "ok") {
            EXPECT_EQ(look.at("value"), look.at("soft_f"));
        }
        if (look.at("rank") == "1") {
            EXPECT_EQ(rows.front().at("soft_f"), look.at("soft_f"));
        }
    }
}

TEST(Hardest, TheViewCanBeDrawnByWhatIsPrinted) {
    const Desk desk;
    const std::string out =
        expect_done(desk,
                    "stress --hardest mote4 --scenes rocket --evaluations 20 --size 128x72 "
                    "--least-truth 40 --out out");
    const std::string begin = "The worst view is of rocket: ";
    ASSERT_THAT(out, HasSubstr(begin));
    const std::size_t at = out.find(begin) + begin.size();
    const std::string view = out.substr(at, out.find('\n', at) - at);
    expect_done(desk,
                "compare rocket --methods mote4 --no-sweep --size 128x72 --out again " + view);
    std::string f;
    for (const auto& look : parse_csv(desk.read("out/hardest.csv")))
        if (look.at("rank") == "1") f = look.at("f_2px");
    for (const auto& row : only(rows_of(desk, "again"), "mote4"))
        EXPECT_EQ(row.at("f_2px"), f);
}

TEST(Hardest, KilledAndStartedAgainItComesToTheSameBytesOnAnyLanes) {
    const Desk desk;
    const auto begin = Clock::now();
    expect_done(desk, small_search("whole") + "--lanes 1");
    const auto whole = Clock::now() - begin;
    const std::string expected = bytes_of(desk, "whole");
    expect_done(desk, small_search("lanes") + "--lanes 2");
    EXPECT_EQ(bytes_of(desk, "lanes"), expected);
    for (int i = 1; i <= 3; ++i) {
        const auto deadline = Clock::now() + whole * i / 5;
        (void)desk.kill_when(small_search("killed") + "--lanes 1",
                             [&] { return Clock::now() >= deadline; });
    }
    expect_done(desk, small_search("killed") + "--lanes 1");
    EXPECT_EQ(bytes_of(desk, "killed"), expected);
}

TEST(Hardest, RefusesWhatItCannotSearch) {
    const Desk desk;
    expect_all_refused(desk,
                       "stress --hardest mote4 --scenes cube",
                       {{"--scenes cubb", "--scenes cubb cube"},
                        {"--against mote4", {"cannot lose to itself"}},
                        {"--against x", "--against x"},
                        {"--evaluations 0", "--evaluations 0"},
                        {"--worst 0", "--worst 0"},
                        {"--least-truth 0", "--least-truth 0"},
                        {"--axes grazing", "--axes --hardest"},
                        {"--antialias none", "--antialias --hardest"}});
    expect_all_refused(desk,
                       "stress",
                       {{"--hardest mote5 --scenes cube", "--hardest mote5 mote4"},
                        {"--hardest mote4", {"--scenes", "no scene"}},
                        {"--against mote4", "--against --hardest"},
                        {"cube", "--scenes --hardest"}});
    EXPECT_THAT(expect_done(desk, "stress --help"), HasSubstr("1.05 to 6 radii"));
}

TEST(Hardest, IsAnExperimentFileToo) {
    const Desk desk;
    desk.write("hard.toml",
               "name = \"hard\"\nkind = \"hardest\"\n[grid]\nscenes = [\"cube\"]\n"
               "sizes = [\"96x54\"]\n[search]\nmethods = [\"mote4\"]\nevaluations = 8\n"
               "least_truth_px = 20\nworst = 1\n");
    expect_done(desk, "run hard.toml");
    EXPECT_NE(desk.read("inkbench-out/hard/hardest.csv"), "");
    desk.write("none.toml", "name = \"none\"\nkind = \"hardest\"\n[grid]\nscenes = [\"cube\"]\n");
    EXPECT_THAT(refusal(desk, "run none.toml"), HasSubstr("no method is searched"));
}

}  // namespace
}  // namespace ink::program
