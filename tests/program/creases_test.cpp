#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/program/run_program.h"

// `--creases`, as a user gives it.

namespace ink::program {
namespace {

/// The first .glb below the folder, as a path in `work()`.
std::string exported_glb(const Desk& desk, const std::string& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(desk.work() / folder)) {
        if (entry.path().extension() == ".glb")
            return std::filesystem::relative(entry.path(), desk.work()).string();
    }
    ADD_FAILURE() << folder << " has no .glb";
    return "";
}

TEST(Creases, OfBakedEdgesAreThoseOfTheAngle) {
    const Desk desk;
    for (const std::string scene : {"bracket", "staircase", "torus"}) {
        expect_done(desk, fmt::format("export {0} --size 96x54 -o {0} --truth none", scene));
        const std::string glb = exported_glb(desk, scene);
        expect_done(desk, fmt::format("bake {} -o {}.glb --edges", glb, scene));
        for (const char* creases : {"angle", "file"}) {
            expect_done(desk,
                        fmt::format("truth {0}.glb --size 320x180 --creases {1} --image {1}.png "
                                    "--no-cache --quiet",
                                    scene,
                                    creases));
        }
        EXPECT_EQ(desk.read("file.png"), desk.read("angle.png")) << scene;
    }
}

TEST(Creases, OfBakedEdgesKeepTheAngleThatTheyWereBakedWith) {
    const Desk desk;
    expect_done(desk, "export torus --size 96x54 -o torus --truth none");
    const std::string glb = exported_glb(desk, "torus");
    expect_done(desk, fmt::format("bake {} -o fine.glb --edges --crease-deg 1", glb));
    const auto image = [&](const std::string& words) {
        expect_done(desk,
                    "truth fine.glb --size 320x180 --no-cache --quiet --image a.png " + words);
        return desk.read("a.png");
    };
    EXPECT_EQ(image("--creases file"), image("--crease 1"));
    EXPECT_NE(image("--creases file"), image("--creases angle"));
}

TEST(Creases, OfAFileThatMarksNoneAndOtherWordsAreRefused) {
    expect_all_refused(Desk(),
                       {},
                       {{"truth cube --creases file -o a.png",
                         {"cube", "it marks no edges", "EXT_mesh_primitive_edge_visibility"}},
                        {"compare --scenes cube --creases file --out out", {"it marks no edges"}},
                        {"truth cube --creases edges -o a.png", {"edges", "angle", "file"}}});
}

}  // namespace
}  // namespace ink::program
