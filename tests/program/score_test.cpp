#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

// Images from elsewhere, as a user scores them.

namespace ink::program {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Score, TheProgramsOwnDrawingAgainstItsTruthNeedsNoOption) {
    const Desk desk;
    expect_done(desk, "truth cube --size 160x90 -o truth.exr");
    expect_done(desk, "draw cube --methods ids --size 160x90 -o drawn.png");
    const std::string scored =
        expect_done(desk, "score drawn.png truth.exr --picture errors.png --csv s.csv");
    EXPECT_THAT(scored, HasSubstr("dark lines on light"));
    EXPECT_THAT(scored, HasSubstr("1 contour"));
    EXPECT_THAT(desk.read("errors.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(desk.read("s.csv"), HasSubstr("drawn.png,ok,"));
    const auto json = nlohmann::json::parse(desk.run("score drawn.png truth.exr --json").out);
    EXPECT_GT(json["f"], 0.9);
    EXPECT_EQ(json["polarity"], "dark");
    EXPECT_EQ(json["band"], 6);
    EXPECT_EQ(json["ignore"], 7);
    expect_done(desk, "score drawn.png truth.exr --fail-under 0.9");
    const Outcome low = desk.run("score drawn.png truth.exr --fail-under 1");
    EXPECT_EQ(low.exit_code, 1);
    EXPECT_THAT(low.err, HasSubstr("is below 1"));
}

TEST(Score, FoldersGiveALineEachAndTellWhatIsMissing) {
    const Desk desk;
    std::filesystem::create_directories(desk.work() / "truths");
    std::filesystem::create_directories(desk.work() / "drawn");
    expect_done(desk, "truth cube --size 96x54 -o truths/cube.exr");
    expect_done(desk, "truth torus --size 96x54 -o truths/torus.exr");
    expect_done(desk, "draw cube --methods ids --size 96x54 -o drawn/cube.png");
    const Outcome outcome = desk.run("score drawn truths --picture errors");
    EXPECT_EQ(outcome.exit_code, 3) << "one has no score";
    EXPECT_THAT(outcome.out, HasSubstr("cube"));
    EXPECT_THAT(outcome.out, HasSubstr("no score: torus: there is no image of this name"));
    EXPECT_THAT(desk.read("errors/cube.png"), StartsWith("\x89PNG"));
    refusal(desk, "score drawn truths/cube.exr");
    refusal(desk, "score drawn/cube.png truths/cube.exr --polarity x");
}

}  // namespace
}  // namespace ink::program
