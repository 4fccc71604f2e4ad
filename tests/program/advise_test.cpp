#include <gmock/gmock.h>

#include <algorithm>

#include "tests/program/run_program.h"

// `inkbench advise` as a user runs it, on scenes small enough to be quick.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

nlohmann::json advice(const Desk& desk, const Words& words) {
    return expect_json(desk, "advise --size 160x90 --json" + words);
}

TEST(Advise, SaysInFiveLinesWhatToUse) {
    const Desk desk;
    desk.write("my cube.obj", kCubeObj);
    const std::string out =
        expect_done(desk, Words{"advise", "my cube.obj"} + "--size 160x90 --views 1");
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 5);
    EXPECT_THAT(out,
                AllOf(ContainsRegex("^use        [a-z0-9_]+(: another run may name .*)?\n"),
                      ContainsRegex("\nexpect     F [01][.][0-9]+ in [0-9.]+ ms .*: "
                                    "inkbench-out/advise/my_cube.png\n"),
                      HasSubstr("\nrunner-up  "),
                      ContainsRegex("\nmoves      0[.][0-9] MB a frame of 160x90 .* GB/s, "),
                      HasSubstr("\nnext       inkbench compare ")));
    // What it draws is right where the truth is: the picture is one, and of the view's size.
    expect_done(desk, Words{"truth", "my cube.obj", "-o", "truth.png"} + "--size 160x90 --views 1");
    EXPECT_THAT(desk.run("score inkbench-out/advise/my_cube.png truth.png").out, HasSubstr("F "));
}

TEST(Advise, NamesTheNextCommandAsAShellTakesIt) {
    const Desk desk;
    desk.write("my cube.obj", kCubeObj);
    const auto json = advice(desk, Words{"my cube.obj"} + "--eye 3,2,4 --fov 30 -o a.png");
    const std::string next = json.at("next");
    EXPECT_THAT(next,
                AllOf(StartsWith("inkbench compare 'my cube.obj' "),
                      HasSubstr(" --size 160x90 --eye 3,2,4 --fov 30 "),
                      EndsWith(" --methods " + json.at("use").at("method").get<std::string>() +
                               "," + json.at("runner_up").at("method").get<std::string>())));
    const std::string inkbench = "inkbench() { " INK_PROGRAM " \"$@\"; }; ";
    const Outcome plan = desk.run_other("/bin/sh", {"-c", inkbench + next + " --dry-run"});
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_THAT(plan.out, HasSubstr("my cube eye0 160x90"));
}

TEST(Advise, JsonHoldsTheSame) {
    const Desk desk;
    const auto json = advice(desk, "cube -o a.png");
    for (const char* which : {"use", "runner_up"}) {
        EXPECT_GT(json.at(which).at("f_2px"), 0.9) << which;
        EXPECT_GT(json.at(which).at("draw_ms"), 0) << which;
        EXPECT_GT(json.at(which).at("recall_by_class").at("contour"), 0.9) << which;
    }
    EXPECT_TRUE(json.at("as_cheap").is_array());
    EXPECT_EQ(json.at("picture"), "a.png");
    EXPECT_THAT(desk.read("a.png"), StartsWith("\x89PNG"));
    EXPECT_EQ(json.at("counts_crowded"), false);
    EXPECT_THAT(json.at("next").get<std::string>(), HasSubstr(" --views 8 "));
    const double bytes = json.at("bytes_per_frame");
    EXPECT_GT(bytes, 160 * 90);
    EXPECT_DOUBLE_EQ(json.at("bandwidth_ms"),
                     bytes / json.at("bandwidth_gb_s").get<double>() * 1e-6);
    EXPECT_TRUE(json.contains("shader_instructions"));
}

const std::vector<std::string> kOfImages = {
    "roberts", "roberts_tuned", "sobel", "decaudin", "plane_distance"};

// Which they are, FindAnswer and VerdictTable test by written times: here times are the machine's.
TEST(Advise, NamesTheMethodsThatMayBeAsCheap) {
    const auto json = advice(Desk(), "knot --have depth,normals --f-margin 1 -o a.png");
    EXPECT_THAT(json.at("as_cheap"), Not(testing::Contains(json.at("use").at("method"))));
    for (const auto& method : json.at("as_cheap"))
        EXPECT_THAT(kOfImages, testing::Contains(method));
}

TEST(Advise, OfAFrameWithoutTheMeshNamesAMethodOfImages) {
    const auto json = advice(Desk(), "cube --have depth,normals");
    for (const char* which : {"use", "runner_up"})
        EXPECT_THAT(kOfImages, testing::Contains(json.at(which).at("method"))) << which;
}

TEST(Advise, CountsCrowdedLinesWhereEveryViewIsCrowded) {
    const Desk desk;
    const Words bush = "bush --size 240x135 --views 1";
    const std::string out = expect_done(desk, "advise" + bush);
    EXPECT_THAT(out, HasSubstr("on one thread here, over 1 view, with lines too dense to score: "));
    EXPECT_THAT(desk.read("inkbench-out/advise/bush.png"), StartsWith("\x89PNG"));
}

TEST(Advise, IsWhatAModelAloneAsksFor) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    for (const char* model : {"cube.obj", "cube"})
        EXPECT_THAT(expect_done(desk, Words{model} + "--size 160x90"),
                    AllOf(StartsWith("use        "), HasSubstr("\nnext       inkbench compare ")));
    EXPECT_THAT(refusal(desk, "cubes.obj"), HasSubstr("no such command or model"));
}

TEST(Advise, BeyondTheBudgetIsTheFastest) {
    const Desk desk;
    const Words tight = "cube --budget-ms 0.0001 -o a.png";
    EXPECT_THAT(expect_done(desk, "advise --size 160x90" + tight),
                ContainsRegex("^use        [a-z0-9_]+: the fastest, as none takes at most 0.0001 "
                              "ms\nexpect     F [01][.][0-9]+ in "));
    const auto json = advice(desk, tight);
    EXPECT_EQ(json.at("within_budget"), false);
    EXPECT_GT(json.at("use").at("f_2px"), 0.5);
    EXPECT_THAT(json.at("next").get<std::string>(), Not(HasSubstr("--budget-ms")));
}

TEST(Advise, SaysWhyThereIsNone) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const Outcome empty = desk.run("advise cube.obj --size 160x90 --eye 0,0,5 --target 0,0,10");
    EXPECT_EQ(empty.exit_code, 1);
    EXPECT_EQ(empty.out, "");
    EXPECT_THAT(empty.err, AllOf(HasSubstr("empty: no line"), HasSubstr("there is no verdict")));
    EXPECT_EQ(desk.inventory().size(), 1U) << "the model";
}

TEST(Advise, RefusesWhatItCannotRead) {
    const Desk desk;
    for (const std::string have : {"", "depth", "normals", "mesh,fog", "deep,normals"})
        expect_refused(desk, Words{"advise", "cube", "--have", have}, {"--have", "mesh, or depth"});
    expect_all_refused(desk, "advise cube -o", {{"a.jpg", "a.jpg"}, {"nowhere/a.png", "nowhere"}});
}

}  // namespace
}  // namespace ink::program
