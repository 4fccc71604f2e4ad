#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Hardest, WritesRowsOfTheWorstViewsAndAPage) {
    const Desk desk;
    const std::string out = expect_done(
        desk,
        "stress --hardest mote4 --against ids --scenes rocket,staircase,gear --evaluations 30 "
        "--least-truth 40 --worst 2 --size 128x72 --seed 3 --no-cache --out out");
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
    desk.write("none.toml", "name = \"none\"\nkind = \"hardest\"\n[grid]\nscenes = [\"cube\"]\n");
    EXPECT_THAT(refusal(desk, "run none.toml"), HasSubstr("no method is searched"));
}

}  // namespace
}  // namespace ink::program
