#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/program/page_data.h"
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
    const Outcome tried = desk.run({"entrant-test", program, "--size", "160x90"});
    EXPECT_EQ(tried.exit_code, 0) << tried.out << tried.err;
    EXPECT_THAT(tried.out, HasSubstr("is ready"));
    const Outcome outcome = desk.run({"compare",
                                      "--scenes",
                                      "cube,torus",
                                      "--methods",
                                      "ids",
                                      "--size",
                                      "160x90",
                                      "--entrant",
                                      "mine=" + program,
                                      "--no-sweep",
                                      "--no-crosscheck",
                                      "--out",
                                      "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("mine +"), HasSubstr("by their own clock")));
    for (const auto& row : parse_csv(desk.read("out/rows.csv"))) {
        if (row.at("method") != "mine") continue;
        EXPECT_EQ(row.at("status"), "ok");
        EXPECT_EQ(row.at("clock"), "own");
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
    const Outcome tried = desk.run({"entrant-test", program, "--size", "160x90"});
    EXPECT_EQ(tried.exit_code, 1);
    EXPECT_THAT(tried.out, HasSubstr("exit code 7: no licence"));
    const Outcome outcome = desk.run({"compare",
                                      "--scenes",
                                      "cube",
                                      "--methods",
                                      "ids",
                                      "--size",
                                      "96x54",
                                      "--entrant",
                                      "mine=" + program,
                                      "--no-sweep",
                                      "--no-crosscheck",
                                      "--out",
                                      "out"});
    EXPECT_EQ(outcome.exit_code, 3) << "some cells have no score";
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("no licence"), HasSubstr("entrant-test")));
}

TEST(Export, ImagesDrawnFromItComeBackAsAFolder) {
    const Desk desk;
    ASSERT_EQ(desk.run({"export", "cube", "teapot", "--size", "96x54", "-o", "views"}).exit_code,
              0);
    for (const char* file : {"views.csv",
                             "cube/mesh.obj",
                             "cube/mesh.glb",
                             "cube/front/camera.json",
                             "cube/front/buffers.exr",
                             "cube/front/ids.png",
                             "cube/front/truth.exr"})
        EXPECT_TRUE(fs::exists(desk.work() / "views" / file)) << file;
    const auto views = parse_csv(desk.read("views/views.csv"));
    EXPECT_GE(views.size(), 4U);
    for (const auto& view : views) {
        EXPECT_EQ(fs::exists(desk.work() / "views" / view.at("folder") / "truth.exr"),
                  view.at("scene") == "cube")
            << "held-out scenes keep their truth";
        const std::string image = "mine/" + view.at("scene") + "/" + view.at("view") + ".png";
        fs::create_directories((desk.work() / image).parent_path());
        ASSERT_EQ(desk.run({"draw",
                            view.at("scene"),
                            "--view",
                            view.at("view"),
                            "--method",
                            "ids",
                            "--size",
                            "96x54",
                            "-o",
                            image})
                      .exit_code,
                  0);
    }
    ASSERT_EQ(desk.run({"compare",
                        "--scenes",
                        "cube,teapot",
                        "--methods",
                        "ids",
                        "--size",
                        "96x54",
                        "--entrant",
                        "mine=mine",
                        "--no-sweep",
                        "--no-crosscheck",
                        "--out",
                        "out"})
                  .exit_code,
              0);
    std::map<std::string, std::string> f;
    for (const auto& row : parse_csv(desk.read("out/rows.csv")))
        f[row.at("method")] += row.at("f_2px") + " ";
    EXPECT_EQ(f.at("mine"), f.at("ids")) << "the same images, the same scores";
}

TEST(Export, ModelsReadBackTheSame) {
    const Desk desk;
    ASSERT_EQ(desk.run({"export", "blocks", "--size", "96x54", "-o", "views", "--truth", "none"})
                  .exit_code,
              0);
    const auto triangles = [&](const std::string& scene) {
        return nlohmann::json::parse(
            desk.run({"explain", scene, "--json"}).out)["statistics"]["triangles"];
    };
    EXPECT_EQ(triangles("views/blocks/mesh.obj"), triangles("blocks"));
    EXPECT_EQ(triangles("views/blocks/mesh.glb"), triangles("blocks"));
}

TEST(Export, RefusesWhatItCannotDo) {
    const Desk desk;
    EXPECT_EQ(desk.run({"export", "-o", "views"}).exit_code, 2);
    EXPECT_EQ(desk.run({"export", "cube", "--truth", "some", "-o", "views"}).exit_code, 2);
    EXPECT_EQ(desk.run({"compare", "--scenes", "cube", "--entrant", "mine=nowhere"}).exit_code, 2);
}

}  // namespace
}  // namespace ink::program
