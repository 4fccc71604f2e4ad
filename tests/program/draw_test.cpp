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

TEST(Draw, EveryLookIsAnotherImage) {
    const Desk desk;
    std::set<std::string> images;
    const std::vector<Words> looks = {"",
                                      "--shading gouraud",
                                      "--shading toon",
                                      "--shading gooch",
                                      "--shading strokes",
                                      "--shading gouraud --dither 565",
                                      "--shading gouraud --dither 332",
                                      "--shading gooch --set-shade lit=warm",
                                      "--shading toon --surface 200,40,40",
                                      "--ink #c02000",
                                      "--paper 250,240,220",
                                      "--line-width 1",
                                      "--line-width 4",
                                      "--antialias 4"};
    for (const Words& look : looks)
        images.insert(draw(desk, look));
    EXPECT_EQ(images.size(), looks.size());
}

TEST(Draw, TheSameWordsGiveTheSameImage) {
    const Desk desk;
    const Words words = "--shading strokes --antialias 2";
    const std::string one = draw(desk, words);
    EXPECT_EQ(draw(desk, words, "b.png"), one);
    EXPECT_EQ(draw(desk, words + "--threads 3", "c.png"), one);
}

TEST(Draw, AColourIsTheSameInBothSpellings) {
    const Desk desk;
    EXPECT_EQ(draw(desk, {"--ink", "#c02000"}), draw(desk, {"--ink", "192,32,0"}));
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
    const Words alone = "--shading gouraud --no-lines";
    const std::string shading = draw(desk, alone);
    EXPECT_NE(shading, draw(desk, "--shading gouraud"));
    EXPECT_EQ(draw(desk, alone + "--method decaudin"), shading);
}

TEST(Draw, ShadingsAndTheirParametersAreListed) {
    for (const char* word : {"gouraud", "toon", "gooch", "strokes", "splash_alpha"})
        EXPECT_THAT(expect_done(Desk(), {"list", "shadings"}), HasSubstr(word));
}

TEST(Draw, ValuesThatMeanNothingAreRefused) {
    expect_all_refused(Desk(),
                       "draw torus --size 160x90 -o a.png",
                       {{"--layer packt", {"--layer", "mote4", "'packt'", "packed, filtered"}},
                        {"--method back_faces --layer ids", "--layer back_faces"},
                        {"--shading tone", "--shading 'tone' gouraud"},
                        {"--shading toon --set-shade steps=40", "steps 40 1..32"},
                        {"--shading toon --set-shade step=4", "'step' steps"},
                        {"--shading toon --set-shade steps", "--set-shade key=value"},
                        {"--ink black", "--ink 'black' #rrggbb"},
                        {"--paper 1,2,256", "--paper 1,2,256 0..255"},
                        {"--shading toon --surface #12345", "--surface #12345"},
                        {"--dither 444", "--dither 444 565"},
                        {"--line-width -1", "--line-width 0..64"},
                        {"--line-width nan", "--line-width 0..64"},
                        {"--antialias 9", "--antialias 1..8"}});
}

TEST(Draw, OptionsThatWouldDoNothingAreRefused) {
    expect_all_refused(Desk(),
                       "draw torus --size 160x90 -o a.png",
                       {{"--no-lines", "--no-lines --shading"},
                        {"--shading toon --no-lines --response", "--no-lines --response"},
                        {"--layer packed --response", "--layer --response"},
                        {"--layer packed --antialias 2", "--layer looks"},
                        {"--set-shade ambient=1", "--set-shade --shading"},
                        {"--surface 1,2,3", "--surface --shading"}});
}

}  // namespace
}  // namespace ink::program
