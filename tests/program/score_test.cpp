#include <gmock/gmock.h>

#include <map>

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
    const auto json = expect_json(desk, "score drawn.png truth.exr --json");
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
    for (const char* folder : {"truths", "drawn"})
        std::filesystem::create_directories(desk.work() / folder);
    for (const char* work : {"truth cube -o truths/cube.exr",
                             "truth torus -o truths/torus.exr",
                             "draw cube --methods ids -o drawn/cube.png"})
        expect_done(desk, work + Words("--size 96x54"));
    const Outcome outcome = desk.run("score drawn truths --picture errors --markdown s.md");
    EXPECT_EQ(outcome.exit_code, 3) << "one has no score";
    EXPECT_THAT(outcome.out, HasSubstr("cube"));
    EXPECT_THAT(outcome.out, HasSubstr("no score: torus: there is no image of this name"));
    EXPECT_THAT(desk.read("errors/cube.png"), StartsWith("\x89PNG"));
    const std::string summary = desk.read("s.md");
    EXPECT_THAT(summary, StartsWith("| image | F |"));
    EXPECT_THAT(summary, HasSubstr("\n| all, pooled | 0.9"));
    EXPECT_THAT(summary, HasSubstr("|\n\n- no score: torus: there is no image of this name"));
    refusal(desk, "score drawn truths/cube.exr");
    refusal(desk, "score drawn/cube.png truths/cube.exr --polarity x");
}

TEST(Score, FilesWithoutATruthAreNamed) {
    const Desk desk;
    for (const char* folder : {"truths", "drawn"})
        std::filesystem::create_directories(desk.work() / folder);
    for (const char* work : {"truth cube -o truths/cube.png",
                             "draw cube -o drawn/cube.exr",
                             "draw cube -o drawn/extra.png"})
        expect_done(desk, work + Words("--size 96x54"));
    const Outcome scored = desk.run("score drawn truths --json");
    EXPECT_EQ(scored.exit_code, 0);
    EXPECT_THAT(scored.err, HasSubstr("truths has no truth for extra.png"));
    const auto json = nlohmann::json::parse(scored.out);
    EXPECT_EQ(json.at("unmatched"), nlohmann::json({"extra.png"}));
    EXPECT_EQ(json.at("images").at("cube").at("notes").size(), 2U);
    EXPECT_THAT(
        desk.run("score drawn truths").out,
        HasSubstr("read as float values as a screen shows them (sRGB); its greys taken as light, "
                  "as the file says: cube\n"));
}

TEST(Score, AModelIsTracedInTheSizeOfTheImage) {
    const Desk desk;
    for (const char* work : {"truth torus -o truth.exr",
                             "truth torus -o truth.png",
                             "draw torus --method ids -o drawn.exr",
                             "draw torus --method ids -o drawn.png"})
        expect_done(desk, work + Words("--size 160x90"));
    const auto expected = expect_json(desk, "score drawn.png truth.exr --json");
    EXPECT_EQ(expect_json(desk, "score drawn.png truth.png --json"), expected);
    EXPECT_EQ(expect_json(desk, "score drawn.png --model torus --json"), expected);
    EXPECT_EQ(expect_json(desk, "score drawn.exr --model torus --json")["f"], expected["f"]);
    EXPECT_LT(std::filesystem::file_size(desk.work() / "truth.png"), 4000U);
    expect_all_refused(
        desk,
        "score",
        {{"drawn.png --model torus --size 64x36", {"inkbench score drawn.png --model torus"}},
         {"drawn.png truth.exr --model torus", {"there is a --model beside it"}},
         {"drawn.png", {"truth: it is missing"}},
         {"drawn.png truth.exr --views 3", {"--views requires --model"}},
         {". --model torus", {"one image"}}});
}

/// A triangle and two cameras that see it.
constexpr const char* kTwoCameras = R"({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
"nodes": [{"mesh": 0}, {"camera": 0, "name": "near", "translation": [0.3, 0.3, 2]},
          {"camera": 0, "name": "far", "translation": [0.3, 0.3, 4]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36,
    "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

TEST(Score, AModelFileIsSeenByItsOwnCameras) {
    const Desk desk;
    desk.write("scene.gltf", kTwoCameras);
    expect_done(desk,
                "draw scene.gltf --views file --view far --method ids --size 160x90 -o render.exr");
    const auto score = [&](const std::string& view) {
        const Outcome scored =
            desk.run("score render.exr --model scene.gltf --views file --json --view " + view);
        EXPECT_EQ(scored.exit_code, 0) << scored.err;
        return nlohmann::json::parse(scored.out);
    };
    EXPECT_GT(score("far").at("f"), 0.9);
    EXPECT_LT(score("near").at("f"), 0.5);
}

/// Pictures of drawn.png, dark lines on white, as they come from elsewhere.
constexpr const char* kImages = R"(
import numpy as np
from PIL import Image, ImageOps

drawn = Image.open("drawn.png").convert("L")
grey = np.array(drawn)
ink = 255 - grey

def overlay(value):
    rgba = np.full(grey.shape + (4,), value, np.uint8)
    rgba[..., 3] = ink
    return Image.fromarray(rgba)

Image.fromarray(grey.astype(np.uint16) * 257).save("sixteen.png")
overlay(0).save("black_overlay.png")
overlay(255).save("white_overlay.png")
yellow = np.stack([np.full_like(grey, 255), np.full_like(grey, 240), grey], -1)
yellow[grey == 255] = 255
Image.fromarray(yellow).save("yellow.png")
ImageOps.flip(drawn).save("flipped.png")
ImageOps.mirror(drawn).save("mirrored.png")
shifted = np.full_like(grey, 255)
shifted[:-3, 8:] = grey[3:, :-8]
Image.fromarray(shifted).save("shifted.png")
Image.new("RGB", drawn.size, (255, 255, 255)).save("blank.png")
drawn.save("photo.jpg", quality=60)
Image.open("large.png").convert("L").resize(drawn.size, Image.LANCZOS).save("halved.png")
ImageOps.expand(ImageOps.crop(ImageOps.invert(drawn), 20), 20, 255).save("framed.png")
open("cut.jpg", "wb").write(open("photo.jpg", "rb").read()[:5000])
)";

TEST(Score, OfImagesFromElsewhereSaysHowItReadThemAndWhatIsWrong) {
    const Desk desk;
    if (desk.run_other("/usr/bin/python3", {"-c", "import numpy, PIL"}).exit_code != 0)
        GTEST_SKIP() << "needs /usr/bin/python3 with numpy and Pillow";
    expect_done(desk, "truth blocks --size 320x180 -o truth.png --intersections above_crease");
    for (const char* file : {"drawn.png", "float.exr"})
        expect_done(desk, Words("draw blocks --size 320x180 --method surface8 -o") + Words{file});
    expect_done(desk, "draw blocks --size 640x360 --method surface8 -o large.png");
    desk.write("images.py", kImages);
    ASSERT_EQ(desk.run_other("/usr/bin/python3", {"images.py"}).exit_code, 0);
    expect_refused(desk, "score cut.jpg truth.png", {"cut.jpg: the file is cut off"});
    const auto score = [&](const std::string& file) {
        const Outcome outcome = desk.run({"score", file, "truth.png", "--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    };
    const double f = score("drawn.png").at("f");
    EXPECT_GT(f, 0.9);

    struct Said {
        std::string notes;
        std::string doubts;
    };
    const std::map<std::string, Said> of_images = {
        {"drawn.png", {"its greys taken as light, as the file says", ""}},
        {"sixteen.png", {"16 bits rounded to 8", ""}},
        {"float.exr", {"float values as a screen shows them (sRGB)", ""}},
        {"black_overlay.png", {"its alpha laid over white", ""}},
        {"white_overlay.png", {"its alpha laid over black", ""}},
        {"yellow.png", {"lines by the blue channel", ""}},
        {"photo.jpg", {"", ""}},
        {"flipped.png", {"", "it seems to be upside down"}},
        {"mirrored.png", {"", "it seems to be mirrored"}},
        {"shifted.png", {"", "it seems to be shifted by 8 px to the right and 3 px up"}},
        {"halved.png",
         {"",
          "its lines are faint, half of them at most 108 of 255: at threshold 64 F would be "
          "0.998"}},
        {"framed.png", {"", "a border of 20 px around it counts as drawn"}},
        {"blank.png", {"", "it is blank"}}};
    for (const auto& [file, said] : of_images) {
        SCOPED_TRACE(file);
        const auto json = score(file);
        const auto text = [&](const char* key) {
            return json.at(key).empty() ? "" : json.at(key).at(0).get<std::string>();
        };
        EXPECT_EQ(text("notes"), said.notes);
        EXPECT_EQ(text("doubts"), said.doubts.empty() ? "" : file + ": " + said.doubts);
        if (said.doubts.empty()) {
            EXPECT_NEAR(json.at("f"), f, 0.01);
        } else {
            EXPECT_LT(json.at("f"), f - 0.1) << "the score stays what it is";
        }
    }
}

}  // namespace
}  // namespace ink::program
