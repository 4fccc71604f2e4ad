#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

// Images as a user asks for them; what they hold is tested in tests/shade and tests/draw.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Draws a small torus with these options more; the bytes of the file.
std::string draw(const Desk& desk, const Words& more, const std::string& file = "a.png") {
    EXPECT_EQ(expect_done(desk, Words("draw torus --size 160x90 -o " + file) + more), file + "\n");
    return desk.read(file);
}

/// The same where the options are wrong: one line names all of `parts`.
void expect_refused(const Words& more, const Words& parts) {
    expect_refused(Desk(), "draw torus --size 160x90 -o a.png" + more, parts);
}

TEST(Draw, EveryLookIsAnotherImage) {
    const Desk desk;
    std::set<std::string> images;
    const std::vector<Words> looks = {{},
                                      {"--shading", "gouraud"},
                                      {"--shading", "gouraud", "--lights", "studio"},
                                      {"--shading", "toon"},
                                      {"--shading", "gooch"},
                                      {"--shading", "strokes"},
                                      {"--shading", "gouraud", "--dither", "565"},
                                      {"--shading", "gouraud", "--dither", "332"},
                                      {"--shading", "gooch", "--set-shade", "lit=warm"},
                                      {"--shading", "toon", "--surface", "200,40,40"},
                                      {"--ink", "#c02000"},
                                      {"--paper", "250,240,220"},
                                      {"--line-width", "1"},
                                      {"--line-width", "4"},
                                      {"--antialias", "4"},
                                      {"--hand-drawn"},
                                      {"--hand-drawn", "--seed", "2"},
                                      {"--hand-drawn", "--set-hand", "passes=3"}};
    for (const Words& look : looks)
        images.insert(draw(desk, look));
    EXPECT_EQ(images.size(), looks.size());
}

TEST(Draw, TheSameWordsGiveTheSameImage) {
    const Desk desk;
    const Words words = "--shading strokes --hand-drawn --seed 5 --antialias 2";
    const std::string one = draw(desk, words);
    Words threaded = words;
    threaded.insert(threaded.end(), {"--threads", "3"});
    EXPECT_EQ(draw(desk, words, "b.png"), one);
    EXPECT_EQ(draw(desk, threaded, "c.png"), one);
}

TEST(Draw, AColourIsTheSameInBothSpellings) {
    const Desk desk;
    EXPECT_EQ(draw(desk, {"--ink", "#c02000"}), draw(desk, {"--ink", "192,32,0"}));
}

TEST(Draw, AntialiasedResponsesHaveShadesOfGrey) {
    const Desk desk;
    EXPECT_NE(draw(desk, {"--response", "--antialias", "4"}), draw(desk, {"--response"}));
}

TEST(Draw, ShadingGoesToLayersOfAnExr) {
    const Desk desk;
    const std::string file = draw(desk, {"--shading", "toon"}, "a.exr");
    EXPECT_THAT(file, AllOf(HasSubstr("shading.R"), HasSubstr("response.Y")));
    EXPECT_THAT(draw(desk, {}, "a.exr"), testing::Not(HasSubstr("shading.R")));
}

TEST(Draw, LayersOfAMethodAreImages) {
    const Desk desk;
    const std::string drawing = draw(desk, {});
    const std::string packed = draw(desk, {"--layer", "packed"});
    EXPECT_NE(packed, drawing);
    EXPECT_NE(draw(desk, {"--layer", "filtered"}), packed);
    EXPECT_EQ(draw(desk, {"--layer", "packed", "--threads", "3"}), packed);
    EXPECT_THAT(draw(desk, {"--method", "decaudin"}, "a.exr"),
                AllOf(HasSubstr("depth.R"), HasSubstr("normal.B")));
}

TEST(Draw, ShadingComesWithoutLinesIfAskedFor) {
    const Desk desk;
    const Words gouraud = {"--shading", "gouraud"};
    const Words alone = "--shading gouraud --no-lines";
    const std::string shading = draw(desk, alone);
    EXPECT_NE(shading, draw(desk, gouraud));
    Words other_lines = alone;
    other_lines.insert(other_lines.end(), {"--method", "decaudin"});
    EXPECT_EQ(draw(desk, other_lines), shading);
    expect_refused({"--no-lines"}, {"--no-lines", "--shading"});
    expect_refused({"--shading", "toon", "--no-lines", "--response"}, {"--no-lines", "--response"});
}

TEST(Draw, TheFilesLightsAreThoseIfItHasAny) {
    const Desk desk;
    const Words gouraud = {"--shading", "gouraud"};
    EXPECT_EQ(draw(desk, {"--shading", "gouraud", "--lights", "file"}), draw(desk, gouraud));
    desk.write("dark.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(refusal(desk, "draw dark.obj --shading gouraud --lights file -o dark.png"),
                AllOf(HasSubstr("--lights"), HasSubstr("no light of its own")));
}

TEST(Draw, ALayerThatCountsSaysWhat) {
    EXPECT_THAT(
        expect_done(Desk(), "draw cube --method edge_hash --layer edges --size 160x90 -o a.png"),
        AllOf(HasSubstr("a.png\n54 edges: "), HasSubstr(" 0 boundary (red)")));
}

TEST(Draw, ALayerThatIsNotThereIsRefusedByName) {
    expect_refused({"--layer", "packt"}, {"--layer", "mote4", "'packt'", "packed, filtered"});
    expect_refused({"--method", "back_faces", "--layer", "ids"}, {"--layer", "back_faces"});
    expect_refused({"--layer", "packed", "--response"}, {"--layer", "--response"});
    expect_refused({"--layer", "packed", "--antialias", "2"}, {"--layer", "looks"});
}

TEST(Draw, ShadingsAndTheirParametersAreListed) {
    for (const char* word : {"gouraud", "toon", "gooch", "strokes", "splash_alpha", "jitter_px"})
        EXPECT_THAT(expect_done(Desk(), {"list", "shadings"}), HasSubstr(word));
}

TEST(Draw, HelpNamesTheLooks) {
    const std::string help = Desk().run({"draw", "--help"}).out;
    for (const std::string& option :
         Words("--shading --set-shade --lights --ink --paper --surface --line-width --hand-drawn "
               "--set-hand --seed --antialias --dither none|gouraud|toon|gooch|strokes"))
        EXPECT_THAT(help, HasSubstr(option));
}

TEST(Draw, ValuesThatMeanNothingAreRefused) {
    expect_refused({"--shading", "tone"}, {"--shading", "'tone'", "gouraud"});
    expect_refused({"--shading", "toon", "--set-shade", "steps=40"}, {"steps", "40", "1..32"});
    expect_refused({"--shading", "toon", "--set-shade", "step=4"}, {"'step'", "steps"});
    expect_refused({"--shading", "toon", "--set-shade", "steps"}, {"--set-shade", "key=value"});
    expect_refused({"--shading", "toon", "--lights", "sun"}, {"--lights", "'sun'", "studio"});
    expect_refused({"--lights", "studio"}, {"--lights", "--shading"});
    expect_refused({"--ink", "black"}, {"--ink", "'black'", "#rrggbb"});
    expect_refused({"--paper", "1,2,256"}, {"--paper", "1,2,256", "0..255"});
    expect_refused({"--shading", "toon", "--surface", "#12345"}, {"--surface", "#12345"});
    expect_refused({"--dither", "444"}, {"--dither", "444", "565"});
    expect_refused({"--line-width", "-1"}, {"--line-width", "0..64"});
    expect_refused({"--line-width", "nan"}, {"--line-width", "0..64"});
    expect_refused({"--antialias", "9"}, {"--antialias", "1..8"});
    expect_refused({"--hand-drawn", "--set-hand", "passes=0"}, {"passes", "1..8"});
    expect_refused({"--hand-drawn", "--seed", "x"}, {"--seed", "'x'"});
}

TEST(Draw, OptionsThatWouldDoNothingAreRefused) {
    expect_refused({"--set-shade", "ambient=1"}, {"--set-shade", "--shading"});
    expect_refused({"--surface", "1,2,3"}, {"--surface", "--shading"});
    expect_refused({"--set-hand", "passes=2"}, {"--set-hand", "--hand-drawn"});
    expect_refused({"--seed", "2"}, {"--seed", "--hand-drawn"});
}

}  // namespace
}  // namespace ink::program
