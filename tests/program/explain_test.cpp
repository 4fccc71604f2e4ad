#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/program/run_program.h"

// `inkbench explain` as a user runs it.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Explain, PrintsTheSceneStatisticsAndWhatAutoChose) {
    EXPECT_THAT(expect_done(Desk(), "explain cube"),
                AllOf(HasSubstr("creases"), HasSubstr("auto: what it chose, and why")));
    EXPECT_THAT(expect_done(Desk(), "explain cube --methods mote4"),
                HasSubstr("mote4: what it left undone in the first view"));
}

TEST(Explain, FitsAScreen) {
    const Desk desk;
    const auto lines = [&](const Words& words) {
        return std::ranges::count(expect_done(desk, "explain" + words), '\n');
    };
    for (const char* scene : {"torus", "letters", "bush", "cube --methods mote4,auto"})
        EXPECT_LE(lines(scene), 40) << scene;
}

TEST(Explain, JsonHoldsTheSame) {
    const auto json = expect_json(Desk(), "explain cube --json");
    EXPECT_EQ(json.at("scene"), "cube");
    EXPECT_EQ(json.at("statistics").at("triangles"), 36);  // three cubes
    EXPECT_EQ(json.at("statistics").at("creases"), 36);
    EXPECT_EQ(json.at("statistics").at("crease_proposal"), 40);  // nothing is curved
    EXPECT_EQ(json.at("statistics").at("may_cross"), false);
    EXPECT_EQ(json.at("place").at("cameras").size(), 3U);
    EXPECT_FALSE(json.at("methods").at("auto").at("plan").empty());
    EXPECT_EQ(json.at("methods").at("auto").at("skips").size(), 8U);
}

TEST(Explain, ShowsTheCamerasThatFramingMakes) {
    const Desk desk;
    desk.write("two.obj",
               "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
               "o right\nv 10 0 0\nv 11 0 0\nv 10 1 0\nf 4 5 6\n");
    const auto eye = [&](const std::string& framing) {
        const auto json = expect_json(desk, "explain two.obj --json " + framing);
        return json.at("place").at("cameras").at("view0").at("eye");
    };
    const auto usual = eye("");
    EXPECT_EQ(eye("--fit sphere"), usual);
    const auto fitted = eye("--fit box");
    EXPECT_LT(fitted.at(2).get<double>(), usual.at(2).get<double>()) << "it stands nearer";
    EXPECT_GT(eye("--fit box --margin 0.2").at(2).get<double>(), fitted.at(2).get<double>());
    EXPECT_GT(eye("--object right").at(0).get<double>(), 10.0);
}

TEST(Explain, RefusesFramingThatMeansNothing) {
    const Desk desk;
    desk.write("one.obj", "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_all_refused(desk,
                       "explain one.obj",
                       {{"--fit fog", {"'fog'", "sphere, box"}},
                        {"--margin 0.1", {"--fit box"}},
                        {"--fit box --margin 0.5", "0..0.45"},
                        {"--fit box --eye 1,2,3", {"nothing to frame"}},
                        {"--object right", "'right' left"}});
}

TEST(Explain, TellsWhereACameraWouldStand) {
    const Desk desk;
    desk.write("box.obj",
               "v -1 0 0\nv 3 0 0\nv 3 2 0\nv -1 2 0\nv -1 0 5\nf 1 2 3\nf 1 3 4\nf 1 2 5\n");
    const std::string out = expect_done(desk, "explain box.obj --views 2");
    EXPECT_THAT(out, HasSubstr("box -1,0,0 .. 3,2,5 (4 x 2 x 5)"));
    // The options that it prints for a view draw that view.
    const auto draw = [&](const Words& camera, const char* file) {
        expect_done(desk, fmt::format("draw box.obj --size 160x90 -o {} ", file) + camera);
        return desk.read(file);
    };
    const std::size_t begin = out.find("--eye");
    const Words camera = out.substr(begin, out.find('\n', begin) - begin);
    ASSERT_EQ(camera.size(), 8U);
    EXPECT_EQ(draw(camera, "a.png"), draw({"--views", "2"}, "b.png"));
    const auto json = expect_json(desk, "explain box.obj --json");
    EXPECT_EQ(json.at("place").at("box").at("high"), nlohmann::json({3, 2, 5}));
    EXPECT_EQ(json.at("place").at("cameras").size(), 3U);
}

TEST(Explain, ModelFarOutIsDrawnAsTheSameModelNearZero) {
    const Desk desk;
    const std::string faces = "f 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    desk.write("near.obj", "v 0.01 0 0\nv 1 0.02 0\nv 0 1 0.03\nv 0 0 1\n" + faces);
    desk.write("far.obj",
               "v 691000.01 0 5335000\nv 691001 0.02 5335000\nv 691000 1 5335000.03\n"
               "v 691000 0 5335001\n" +
                   faces);
    const auto json = expect_json(desk, "explain far.obj --json --views 1");
    EXPECT_EQ(json.at("place").at("origin"), nlohmann::json({691001, 0, 5335001}));
    EXPECT_NEAR(json.at("place").at("box").at("high").at(0).get<double>(), 691001, 1e-6);
    EXPECT_THAT(expect_done(desk, "explain far.obj --views 1"),
                HasSubstr("origin 691001,0,5335001, taken out"));
    // Cameras are in the file's coordinates.
    const auto draw = [&](const char* model, const char* eye, const char* target) {
        expect_done(
            desk,
            fmt::format(
                "draw {} --size 160x90 --eye {} --target {} -o out.png", model, eye, target));
        return desk.read("out.png");
    };
    EXPECT_EQ(draw("far.obj", "691003,2,5335004", "691000,0,5335000"),
              draw("near.obj", "3,2,4", "0,0,0"));
}

TEST(Explain, UnknownNamesAndABadAngleAreErrors) {
    expect_all_refused(Desk(),
                       "explain",
                       {{"cubes", {"torus", "did you mean cube?"}},
                        {"cube --set pryce=1", "pryce"},
                        {"cube --crease 181", "181"}});
}

}  // namespace
}  // namespace ink::program
