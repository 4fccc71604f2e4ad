#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// Views without a score: a reason, a remedy, and no part in any number.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kFlatObj = "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3\nf 2 3 4\nf 1 2 4\n";

Outcome compared(const Desk& desk, const Words& more) {
    return desk.run("compare --methods mote4,ids --repetitions 1 --out out" + more);
}

/// A run in which no view has anything: it fails, and shows no F anywhere.
void expect_all_empty(const Words& words, const std::string& why) {
    const Desk desk;
    desk.write("thing.obj", kCubeObj);
    desk.write("flat.obj", kFlatObj);
    const Outcome outcome = compared(desk, words);
    SCOPED_TRACE(testing::PrintToString(words) + outcome.err);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("no score: "),
                      HasSubstr("empty: " + why),
                      HasSubstr("try: a view that shows lines"),
                      HasSubstr("not one cell has a score")));
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("No method was scored on any view"), Not(HasSubstr("1.000"))));
    EXPECT_THAT(desk.read("out/verdict.md"), Not(HasSubstr("1.000")));
    for (const auto& row : rows_of(desk)) {
        EXPECT_THAT(row.at("status"), StartsWith("empty: "));
        for (const auto& [name, value] : row) {
            if (!name.starts_with("f_") && !name.starts_with("n_truth")) continue;
            EXPECT_EQ(value, "") << name;
        }
    }
    for (const auto& line : parse_csv(desk.read("out/summary.csv")))
        EXPECT_EQ(line.at("f_2px"), "") << line.at("method");
    const Table unscored = parse_csv(desk.read("out/unscored.csv"));
    ASSERT_FALSE(unscored.empty());
    EXPECT_THAT(unscored[0].at("reason"), StartsWith("empty: "));
    EXPECT_THAT(unscored[0].at("remedy"), HasSubstr("inkbench explain"));
    EXPECT_THAT(desk.read("out/run.toml"), Not(HasSubstr("invalid")));
}

TEST(EmptyView, HasNoScore) {
    expect_all_empty("flat.obj --size 160x90", "no triangle has an area");
    expect_all_empty("thing.obj --eye 0,0,5 --target 0,0,10 --size 160x90",
                     "no line of the scene is in the image");
    // The band around the image leaves nothing of these.
    expect_all_empty("thing.obj --views 1 --size 13x13", "");
    expect_all_empty("thing.obj --views 1 --size 1x4000", "");
}

TEST(EmptyView, ChangesNoNumberOfTheOthers) {
    const Desk desk;
    desk.write("thing.obj", kCubeObj);
    const Words words = "thing.obj --eye 3,2,4 --target 0.5,0.5,0.5 --size 160x90";
    ASSERT_EQ(compared(desk, words).exit_code, 0);
    const Table alone = parse_csv(desk.read("out/summary.csv"));
    const Outcome outcome = compared(desk, words + "--eye 0,0,5 --target 0,0,10 --force");
    EXPECT_EQ(outcome.exit_code, 3) << "a view has no score";
    EXPECT_THAT(outcome.err, HasSubstr("no score: thing eye1: empty: "));
    const Table both = parse_csv(desk.read("out/summary.csv"));
    ASSERT_EQ(both.size(), alone.size());
    for (std::size_t i = 0; i < both.size(); ++i) {
        for (const auto& [name, value] : both[i]) {
            const bool is_score = name.starts_with("f_") || name.starts_with("recall") ||
                                  name == "precision" || name == "views" || name == "scenes";
            if (!is_score) continue;
            EXPECT_EQ(value, alone[i].at(name)) << name;
        }
    }
    EXPECT_EQ(parse_csv(desk.read("out/unscored.csv")).size(), 1U);
    EXPECT_THAT(desk.read("out/report.html"), HasSubstr("\"unscored.csv\":{\"lines\":1,"));
}

TEST(EmptyView, IsNothingToSearch) {
    const Desk desk;
    desk.write("thing.obj", kCubeObj);
    const Outcome outcome =
        desk.run("tune mote4 thing.obj --evaluations 4 --size 160x90 --eye 0,0,5 --target 0,0,10");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("thing eye0: empty: no line of the scene"));
}

TEST(CrowdedView, IsSaidAndIsNoFailure) {
    const Desk desk;
    const Outcome outcome = compared(desk, "--scenes bush,cube --size 240x135");
    EXPECT_EQ(outcome.exit_code, 0) << "as help and guide have it";
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("no score: bush"), HasSubstr("crowded: "), HasSubstr("try: ")));
    int crowded = 0;
    for (const auto& row : rows_of(desk)) {
        if (!row.at("status").starts_with("crowded")) continue;
        ++crowded;
        EXPECT_EQ(row.at("f_2px"), "");
        EXPECT_EQ(row.at("f_2px_all_intersections"), "");
        EXPECT_NE(row.at("f_2px_with_crowded"), "");
        if (row.at("method") != "oracle") continue;
        EXPECT_EQ(row.at("f_2px_with_crowded"), "1");
    }
    EXPECT_GT(crowded, 0);
}

TEST(EmptyTruth, HasNoF) {
    const Desk desk;
    desk.write("thing.obj", kCubeObj);
    const Words view = "--size 96x54 --eye 0,0,5 --target 0,0,10";
    for (const char* folder : {"truths", "drawn"})
        std::filesystem::create_directories(desk.work() / folder);
    expect_done(desk, "truth thing.obj -o truths/a.png" + view);
    expect_done(desk, "draw thing.obj --methods ids -o drawn/a.png" + view);
    const Outcome table = desk.run("score drawn/a.png truths/a.png --csv a.csv");
    EXPECT_EQ(table.exit_code, 0) << "it was asked for no F";
    EXPECT_THAT(table.out, HasSubstr("F                -"));
    EXPECT_THAT(table.err, HasSubstr("empty: the truth has no pixel that counts"));
    EXPECT_THAT(desk.read("a.csv"), HasSubstr("a.png,\"empty: the truth"));
    const auto json = nlohmann::json::parse(desk.run("score drawn/a.png truths/a.png --json").out);
    EXPECT_TRUE(json["f"].is_null());
    EXPECT_EQ(json["n_truth"], 0);
    const Outcome asked = desk.run("score drawn/a.png truths/a.png --fail-under 0");
    EXPECT_EQ(asked.exit_code, 1);
    EXPECT_THAT(asked.err, HasSubstr("there is no F"));
    const Outcome folder = desk.run("score drawn truths --json");
    EXPECT_EQ(folder.exit_code, 1) << "no image has a score";
    const auto all = nlohmann::json::parse(folder.out);
    EXPECT_TRUE(all["pooled"]["f"].is_null());
    EXPECT_THAT(all["images"]["a"]["status"].get<std::string>(), StartsWith("empty: "));
}

}  // namespace
}  // namespace ink::program
