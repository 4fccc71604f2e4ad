#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

// `inkbench explain` as a user runs it.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Explain, PrintsTheLedgerAndWhatAutoChose) {
    const Outcome outcome = Desk().run({"explain", "cube", "--methods", "mote4,auto"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(without_progress(outcome.err), "");
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("creases"),
                      HasSubstr("mote4: what it may leave out"),
                      HasSubstr("auto: what it chose, and why")));
}

TEST(Explain, JsonHoldsTheSame) {
    const Outcome all = Desk().run({"explain", "cube", "--json"});
    ASSERT_EQ(all.exit_code, 0) << all.err;
    const auto json = nlohmann::json::parse(all.out);
    EXPECT_EQ(json.at("scene"), "cube");
    EXPECT_EQ(json.at("ledger").at("triangles"), 36);  // three cubes
    EXPECT_EQ(json.at("ledger").at("creases"), 36);
    EXPECT_EQ(json.at("ledger").at("may_cross"), false);
    EXPECT_EQ(json.at("views").size(), 3U);
    EXPECT_EQ(json.at("methods").at("mote4").at("skips").at("flat_tiles").at("may"), true);
    EXPECT_FALSE(json.at("methods").at("auto").at("plan").empty());
}

TEST(Explain, ExplainsAModelFileToo) {
    const Desk desk;
    desk.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome = desk.run({"explain", "one.obj", "--json", "--methods", "auto"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("ledger").at("boundary"), 3);
}

TEST(Explain, AnUnknownSceneIsAnErrorThatNamesTheKnownOnes) {
    const Outcome outcome = Desk().run({"explain", "cubes"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("torus"), HasSubstr("did you mean cube?")));
}

TEST(Explain, AnUnknownMethodAndABadAngleAreErrors) {
    EXPECT_EQ(Desk().run({"explain", "cube", "--methods", "mote5"}).exit_code, 2);
    EXPECT_EQ(Desk().run({"explain", "cube", "--crease", "181"}).exit_code, 2);
}

}  // namespace
}  // namespace ink::program
