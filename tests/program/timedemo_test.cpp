#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

// `inkbench timedemo` as a user runs it.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Timedemo, PrintsItsTableAndWritesItsFrames) {
    const Desk desk;
    const Outcome outcome = desk.run({"timedemo",
                                      "gear",
                                      "--methods",
                                      "mote4",
                                      "--frames",
                                      "2",
                                      "--size",
                                      "64x48",
                                      "--out",
                                      "demo"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* row : {"plain",
                            "shading",
                            "no edges",
                            "full",
                            "toon",
                            "sketch",
                            "orbit, first",
                            "dolly, cached",
                            "own lights"})
        EXPECT_THAT(outcome.out, HasSubstr(row));
    EXPECT_EQ(parse_csv(desk.read("demo/timedemo.csv")).size(), 3U * 3 * 2)
        << "paths, passes, frames";
}

TEST(Timedemo, TellsItsRatesAsJson) {
    const Outcome outcome = Desk().run(
        {"timedemo", "gear", "--method", "mote4", "--frames", "2", "--size", "64x48", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("scene"), "gear");
    EXPECT_EQ(json.at("lights"), "file");
    ASSERT_EQ(json.at("rates").size(), 3U * 6 * 2) << "paths, kinds of frame, first and cached";
    for (const auto& rate : json.at("rates")) {
        EXPECT_GT(rate.at("fps"), 0);
        EXPECT_LE(rate.at("low_fps"), rate.at("fps"));
        EXPECT_GE(rate.at("high_fps"), rate.at("fps"));
        const bool is_of_all = rate.at("drawn") == "plain" || rate.at("drawn") == "shading";
        EXPECT_EQ(rate.at("method"), is_of_all ? "" : "mote4");
    }
}

TEST(Timedemo, RefusesAMomentAndAbsurdNumbersOfFrames) {
    const Desk desk;
    EXPECT_EQ(desk.run({"timedemo", "gear", "--time", "1"}).exit_code, 2);
    for (const char* frames : {"0", "1", "-3", "10001", "many"}) {
        const Outcome outcome = desk.run({"timedemo", "gear", "--frames", frames, "--out", "demo"});
        EXPECT_EQ(outcome.exit_code, 2) << frames;
        EXPECT_THAT(outcome.err, HasSubstr("--frames")) << frames;
        EXPECT_TRUE(desk.inventory().empty()) << frames;
    }
}

}  // namespace
}  // namespace ink::program
