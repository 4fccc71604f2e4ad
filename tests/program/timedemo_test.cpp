#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// `inkbench timedemo` as a user runs it.

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(Timedemo, PrintsItsTableAndWritesItsFrames) {
    const Desk desk;
    const std::string out =
        expect_done(desk, "timedemo gear --methods mote4 --frames 2 --size 64x48 --out demo");
    for (const std::string& row : Words("plain shading full toon") +
                                      Words{"no edges", "orbit, first", "dolly, cached"} +
                                      Words{"own lights"})
        EXPECT_THAT(out, HasSubstr(row));
    EXPECT_EQ(parse_csv(desk.read("demo/timedemo.csv")).size(), 3U * 3 * 2)
        << "paths, passes, frames";
}

TEST(Timedemo, TellsItsRatesAsJson) {
    const auto json =
        expect_json(Desk(), "timedemo gear --method mote4 --frames 2 --size 64x48 --json");
    EXPECT_EQ(json.at("scene"), "gear");
    EXPECT_EQ(json.at("lights"), "file");
    ASSERT_EQ(json.at("rates").size(), 3U * 5 * 2) << "paths, kinds of frame, first and cached";
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
    refusal(desk, "timedemo gear --time 1");
    for (const std::string frames : {"0", "1", "-3", "10001", "many"})
        EXPECT_THAT(refusal(desk, "timedemo gear --out demo --frames " + frames),
                    HasSubstr("--frames"));
}

}  // namespace
}  // namespace ink::program
