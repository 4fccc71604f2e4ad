#include <gmock/gmock.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/run_program.h"

// `inkbench explain` as a user runs it.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Explain, PrintsTheSceneStatisticsAndWhatAutoChose) {
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
    EXPECT_EQ(json.at("statistics").at("triangles"), 36);  // three cubes
    EXPECT_EQ(json.at("statistics").at("creases"), 36);
    EXPECT_EQ(json.at("statistics").at("may_cross"), false);
    EXPECT_EQ(json.at("views").size(), 3U);
    EXPECT_EQ(json.at("methods").at("mote4").at("skips").at("flat_tiles").at("may"), true);
    EXPECT_FALSE(json.at("methods").at("auto").at("plan").empty());
}

TEST(Explain, ShowsTheCamerasThatFramingMakes) {
    const Desk desk;
    desk.write("two.obj",
               "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
               "o right\nv 10 0 0\nv 11 0 0\nv 10 1 0\nf 4 5 6\n");
    const auto eye = [&](std::vector<std::string> framing) {
        framing.insert(framing.begin(), {"explain", "two.obj", "--json", "--methods", "ids"});
        const Outcome outcome = desk.run(framing);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out).at("place").at("cameras").at("view0").at("eye");
    };
    const auto usual = eye({});
    EXPECT_EQ(eye({"--fit", "sphere"}), usual);
    const auto fitted = eye({"--fit", "box"});
    EXPECT_LT(fitted.at(2).get<double>(), usual.at(2).get<double>()) << "it stands nearer";
    EXPECT_GT(eye({"--fit", "box", "--margin", "0.2"}).at(2).get<double>(),
              fitted.at(2).get<double>());
    EXPECT_GT(eye({"--object", "right"}).at(0).get<double>(), 10.0);
}

TEST(Explain, RefusesFramingThatMeansNothing) {
    const Desk desk;
    desk.write("one.obj", "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto refusal = [&](std::vector<std::string> framing) {
        framing.insert(framing.begin(), {"explain", "one.obj"});
        const Outcome outcome = desk.run(framing);
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    EXPECT_THAT(refusal({"--fit", "fog"}), AllOf(HasSubstr("'fog'"), HasSubstr("sphere, box")));
    EXPECT_THAT(refusal({"--margin", "0.1"}), HasSubstr("--fit box"));
    EXPECT_THAT(refusal({"--fit", "box", "--margin", "0.5"}), HasSubstr("0..0.45"));
    EXPECT_THAT(refusal({"--fit", "box", "--eye", "1,2,3"}), HasSubstr("nothing to frame"));
    EXPECT_THAT(refusal({"--object", "right"}), AllOf(HasSubstr("'right'"), HasSubstr("left")));
}

TEST(Explain, TellsWhereACameraWouldStand) {
    const Desk desk;
    desk.write("box.obj",
               "v -1 0 0\nv 3 0 0\nv 3 2 0\nv -1 2 0\nv -1 0 5\nf 1 2 3\nf 1 3 4\nf 1 2 5\n");
    const Outcome outcome = desk.run({"explain", "box.obj", "--method", "auto", "--views", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("box -1,0,0 .. 3,2,5 (4 x 2 x 5)"));
    // The options that it prints for a view draw that view.
    const auto draw = [&](const std::vector<std::string>& camera, const char* file) {
        std::vector<std::string> words = {"draw", "box.obj", "--size", "160x90", "-o", file};
        words.insert(words.end(), camera.begin(), camera.end());
        EXPECT_EQ(desk.run(words).exit_code, 0);
        return desk.read(file);
    };
    std::string line = outcome.out.substr(outcome.out.find("--eye"));
    line.resize(line.find('\n'));
    std::istringstream words(line);
    const std::vector<std::string> camera{std::istream_iterator<std::string>(words), {}};
    ASSERT_EQ(camera.size(), 8U);
    EXPECT_EQ(draw(camera, "a.png"), draw({"--views", "2"}, "b.png"));
    const auto json = nlohmann::json::parse(desk.run({"explain", "box.obj", "--json"}).out);
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
    const auto json =
        nlohmann::json::parse(desk.run({"explain", "far.obj", "--json", "--views", "1"}).out);
    EXPECT_EQ(json.at("place").at("origin"), nlohmann::json({691001, 0, 5335001}));
    EXPECT_NEAR(json.at("place").at("box").at("high").at(0).get<double>(), 691001, 1e-6);
    const Outcome outcome = desk.run({"explain", "far.obj", "--views", "1"});
    EXPECT_THAT(outcome.out, HasSubstr("origin 691001,0,5335001, taken out"));
    // Cameras are in the file's coordinates.
    const auto draw = [&](const char* model, const char* eye, const char* target) {
        EXPECT_EQ(desk.run({"draw",
                            model,
                            "--size",
                            "160x90",
                            "--eye",
                            eye,
                            "--target",
                            target,
                            "-o",
                            "out.png"})
                      .exit_code,
                  0);
        return desk.read("out.png");
    };
    EXPECT_EQ(draw("far.obj", "691003,2,5335004", "691000,0,5335000"),
              draw("near.obj", "3,2,4", "0,0,0"));
}

TEST(Explain, ExplainsAModelFileToo) {
    const Desk desk;
    desk.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome = desk.run({"explain", "one.obj", "--json", "--methods", "auto"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("statistics").at("boundary"), 3);
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
