#include <gmock/gmock.h>

#include <map>
#include <string>

#include "tests/program/run_program.h"

// Grey lines and their ink, as a user draws and scores them.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(GreyLines, OfAnyImageAreScoredAgainstAFileOrAModel) {
    const Desk desk;
    expect_done(desk, "truth torus --size 160x90 -o truth.exr");
    expect_done(desk, "draw torus --methods id_lookup --size 160x90 --antialias 4 -o drawn.png");
    // Of grey lines it may say that another threshold suits them better.
    const auto score = [&](const std::string& words) {
        const Outcome outcome = desk.run("score drawn.png " + words);
        EXPECT_EQ(outcome.exit_code, 0) << words << outcome.err;
        return outcome.out;
    };
    const std::string told = score("truth.exr --coverage --csv s.csv");
    EXPECT_THAT(told, HasSubstr("soft F"));
    EXPECT_THAT(told, HasSubstr("grey lines 1.5 px wide"));
    EXPECT_THAT(desk.read("s.csv"), HasSubstr(",soft_f,ink_line_width_px,"));
    const auto scored = [&](const std::string& words) {
        return nlohmann::json::parse(score(words + " --json"));
    };
    const auto of_file = scored("truth.exr --coverage");
    const auto of_model = scored("--model torus --coverage");
    EXPECT_GT(of_file["soft_f"], 0.7);
    for (const char* name : {"soft_f", "ink_matched_px", "ink_missing_px", "ink_surplus_px"})
        EXPECT_NEAR(of_file[name].get<double>(), of_model[name].get<double>(), 1e-3) << name;
    const auto wide = scored("--model torus --coverage --line-width 3");
    EXPECT_EQ(wide["ink_line_width_px"], 3);
    EXPECT_GT(wide["ink_missing_px"], of_file["ink_missing_px"]);
    EXPECT_FALSE(scored("truth.exr").contains("soft_f"));
}

TEST(GreyLines, NeedATruthThatSaysWhatItCovers) {
    const Desk desk;
    expect_done(desk, "truth cube --size 96x54 -o truth.png");
    expect_done(desk, "truth cube --size 96x54 -o truth.exr");
    expect_done(desk, "draw cube --methods ids --size 96x54 -o drawn.png");
    expect_all_refused(desk,
                       "score drawn.png --coverage",
                       {{"truth.png", {"truth.png", "--model MODEL"}},
                        {"truth.exr --line-width 2", {"1.5 px wide, not 2", "--model MODEL"}},
                        {"--model cube --line-width 9", "0.25..4"}});
}

TEST(GreyLines, AreWhatTheAnswerIsByWhereAMethodOfInkIsNamed) {
    const Desk desk;
    const std::string quick = "compare --scenes torus --size 320x180 --quick --images none --out ";
    const std::string told = expect_done(desk, quick + "out --methods strokes,ids");
    EXPECT_THAT(told, HasSubstr("\nstrokes finds 99.9 % of the ink, and "));
    EXPECT_THAT(desk.read("out/run.toml"), HasSubstr("coverage = true"));
    EXPECT_THAT(desk.read("out/soft_differences.csv"), HasSubstr("\nstrokes,ids,0."));
    EXPECT_THAT(desk.read("out/summary.csv"), HasSubstr(",soft_f,soft_lo,soft_hi,"));
    expect_done(desk, quick + "plain --methods surface_lookup,ids");
    EXPECT_THAT(desk.read("plain/summary.csv"), Not(HasSubstr("soft")));
    EXPECT_THAT(desk.read("plain/run.toml"), HasSubstr("coverage = false"));
}

TEST(GreyLines, AreWhatAdviceIsByIfAsked) {
    const Desk desk;
    const std::string asked = "advise torus --views 1 --size 320x180 --coverage";
    EXPECT_THAT(expect_done(desk, asked),
                AllOf(HasSubstr("soft F 0.9"), HasSubstr("% of the ink; ")));
    const auto advice = expect_json(desk, asked + " --json");
    EXPECT_EQ(advice["measure"], "soft_f");
    EXPECT_GT(advice["use"]["soft_f"], 0.9);
    EXPECT_THAT(advice["next"].get<std::string>(), HasSubstr(" --coverage "));
}

TEST(GreyLines, RefuseWhatCannotBeDrawn) {
    expect_all_refused(
        Desk(),
        "compare --out out",
        {{"--antialias resolve9", "resolve9 resolve16"},
         {"--line-width 0", "0.25..4"},
         {"--antialias resolve16 --scenes cube --size 8000x100", {"--antialias", "too large"}}});
}

}  // namespace
}  // namespace ink::program
