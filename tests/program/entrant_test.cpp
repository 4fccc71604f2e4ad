#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/program/run_program.h"

// Methods from outside, as a user brings them.

namespace ink::program {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// The Python program that methods/README.md shows.
std::string readme_program() {
    std::ifstream file(std::string(INK_SOURCE_DIR) + "/methods/README.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::string begin = "```python\n";
    const std::size_t first = page.find(begin) + begin.size();
    return page.substr(first, page.find("```", first) - first);
}

std::string write_program(const Desk& desk, const std::string& name, const std::string& text) {
    desk.write(name, text);
    fs::permissions(desk.work() / name, fs::perms::owner_all);
    return "./" + name;
}

/// Python with numpy and Pillow, which the README's program needs.
bool has_python(const Desk& desk) {
    return desk.run_other("/usr/bin/python3", {"-c", "import numpy, PIL"}).exit_code == 0;
}

TEST(Entrant, TheReadmesTenLinesOfPythonTakePart) {
    const Desk desk;
    if (!has_python(desk)) GTEST_SKIP() << "needs /usr/bin/python3 with numpy and Pillow";
    const std::string program = write_program(desk, "lines.py", readme_program());
    EXPECT_THAT(expect_done(desk, fmt::format("entrant-test {} --size 160x90", program)),
                HasSubstr("is ready"));
    const std::string flips = write_program(
        desk,
        "flips",
        "#!/bin/sh\n" + (desk.work() / "lines.py").string() +
            " \"$1\" \"$2\" && /usr/bin/python3 -c 'import sys; from PIL import Image, ImageOps\n"
            "ImageOps.flip(Image.open(sys.argv[1])).save(sys.argv[1])' \"$2\"\n");
    const Outcome flipped = desk.run({"entrant-test", flips, "--size", "160x90"});
    EXPECT_EQ(flipped.exit_code, 1);
    EXPECT_THAT(flipped.out, HasSubstr("it seems to be upside down"));
    EXPECT_THAT(
        expect_done(desk,
                    fmt::format("compare --scenes cube,torus --methods ids --size 160x90 --entrant "
                                "mine={} --no-sweep --no-crosscheck --out out",
                                program)),
        AllOf(HasSubstr("mine +"), HasSubstr("by their own clock")));
    for (const auto& row : only(rows_of(desk), "mine")) {
        EXPECT_EQ(row.at("status"), "ok");
        EXPECT_EQ(row.at("clock"), "children");
        EXPECT_GT(std::stod(row.at("f_2px")), 0.5);
        EXPECT_GT(std::stod(row.at("draw_ns")), 0);
    }
    EXPECT_THAT(desk.read("out/methods.csv"), HasSubstr("\nmine,entrant,"));
    EXPECT_THAT(desk.read("out/report.html"), HasSubstr("mine"));
}

TEST(Entrant, AFailureIsARowWithAStatus) {
    const Desk desk;
    const std::string program =
        write_program(desk, "fails", "#!/bin/sh\necho 'no licence' >&2\nexit 7\n");
    const Outcome tried = desk.run(fmt::format("entrant-test {} --size 160x90", program));
    EXPECT_EQ(tried.exit_code, 1);
    EXPECT_THAT(tried.out, HasSubstr("exit code 7: no licence"));
    const Outcome outcome =
        desk.run(fmt::format("compare --scenes cube --methods ids --size 96x54 --entrant mine={} "
                             "--no-sweep --no-crosscheck --out out",
                             program));
    EXPECT_EQ(outcome.exit_code, 3) << "some cells have no score";
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("no licence"), HasSubstr("entrant-test")));
}

TEST(Export, ImagesDrawnFromItComeBackAsAFolder) {
    const Desk desk;
    expect_done(desk, "export cube teapot --size 96x54 -o views");
    for (const std::string& file :
         Words("views.csv cube/mesh.obj cube/mesh.glb cube/front/camera.json "
               "cube/front/buffers.exr cube/front/ids.png cube/front/truth.exr"))
        EXPECT_TRUE(fs::exists(desk.work() / "views" / file)) << file;
    const auto views = parse_csv(desk.read("views/views.csv"));
    EXPECT_GE(views.size(), 4U);
    for (const auto& view : views) {
        EXPECT_EQ(fs::exists(desk.work() / "views" / view.at("folder") / "truth.exr"),
                  view.at("scene") == "cube")
            << "held-out scenes keep their truth";
        const std::string image = "mine/" + view.at("scene") + "/" + view.at("view") + ".png";
        fs::create_directories((desk.work() / image).parent_path());
        expect_done(desk,
                    fmt::format("draw {} --view {} --method ids --size 96x54 -o {}",
                                view.at("scene"),
                                view.at("view"),
                                image));
    }
    expect_done(desk,
                "compare --scenes cube,teapot --methods ids --size 96x54 --entrant "
                "mine=mine --no-sweep --no-crosscheck --out out");
    std::map<std::string, std::string> f;
    for (const auto& row : rows_of(desk))
        f[row.at("method")] += row.at("f_2px") + " ";
    EXPECT_EQ(f.at("mine"), f.at("ids")) << "the same images, the same scores";
}

TEST(Export, ModelsReadBackTheSame) {
    const Desk desk;
    expect_done(desk, "export blocks --size 96x54 -o views --truth none");
    const auto triangles = [&](const std::string& scene) {
        return expect_json(desk, "explain --json " + scene)["statistics"]["triangles"];
    };
    EXPECT_EQ(triangles("views/blocks/mesh.obj"), triangles("blocks"));
    EXPECT_EQ(triangles("views/blocks/mesh.glb"), triangles("blocks"));
}

TEST(Export, RefusesWhatItCannotDo) {
    const Desk desk;
    refusal(desk, "export -o views");
    refusal(desk, "export cube --truth some -o views");
    refusal(desk, "compare --scenes cube --entrant mine=nowhere");
}

}  // namespace
}  // namespace ink::program
