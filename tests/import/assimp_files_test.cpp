// What is made of Assimp's scenes.

#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "scene/animation.h"
#include "tests/core/error_text.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"
#include "tests/import/read_meshes.h"
#include "tests/import/scene_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using AssimpFiles = ModelFiles;

TEST_F(AssimpFiles, OrthographicCamerasOfColladaAreTwiceTheirMagnification) {
    const auto height = [&](const std::string& optics) {
        const scene::Scene scene =
            import_scene(write("cam.dae", dae_file("<orthographic>" + optics + "</orthographic>")));
        EXPECT_EQ(scene.cameras.size(), 1U);
        return scene.cameras.at(0).height_world;
    };
    EXPECT_NEAR(height("<xmag>3</xmag><ymag>2</ymag>"), 4, 1e-9);
    EXPECT_NEAR(height("<ymag>2</ymag><aspect_ratio>3</aspect_ratio>"), 4, 1e-9);
    EXPECT_NEAR(height("<xmag>3</xmag><aspect_ratio>1.5</aspect_ratio>"), 4, 1e-9);
}

TEST_F(AssimpFiles, VerticalAnglesOfColladaHold) {
    const auto angle_deg = [&](const std::string& angles) {
        const scene::Scene scene =
            import_scene(write("cam.dae", dae_file("<perspective>" + angles + "</perspective>")));
        EXPECT_EQ(scene.cameras.size(), 1U);
        return scene.cameras.at(0).fov_y_rad * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(angle_deg("<xfov>60</xfov><yfov>40</yfov>"), 40, 1e-9);
    EXPECT_NEAR(angle_deg("<yfov>30</yfov>"), 30, 1e-9);
    EXPECT_NEAR(angle_deg("<yfov>30</yfov><aspect_ratio>2</aspect_ratio>"), 30, 1e-9);
    const double half = std::atan(std::tan(30 * std::numbers::pi / 180) / 2);
    EXPECT_NEAR(angle_deg("<xfov>60</xfov><aspect_ratio>2</aspect_ratio>"),
                2 * half * 180 / std::numbers::pi,
                1e-9);
}

TEST_F(AssimpFiles, ANodesMeshesAreOneObject) {
    const scene::Scene scene = import_scene(write("two.dae", dae_file("<perspective/>")));
    ASSERT_EQ(scene.meshes.size(), 1U) << "both nodes share it";
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[0].name, "left");
    EXPECT_EQ(scene.instances[1].name, "right");
    EXPECT_EQ(scene::to_world(scene.instances[1], {0, 0, 0}), glm::dvec3(5, 0, 0));
    const scene::Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.triangles.size(), 2U);
    ASSERT_EQ(mesh.materials.size(), 2U);
    EXPECT_NE(mesh.materials[0], mesh.materials[1]);
}

TEST_F(AssimpFiles, NothingIsMadeUpForFilesWithoutMeshes) {
    const std::string bones = replaced(dae_file("<perspective/>"),
                                       "<node id=\"left\">",
                                       "<node id=\"hip\" type=\"JOINT\"><node id=\"knee\" "
                                       "type=\"JOINT\"><translate>0 1 0</translate></node></node>"
                                       "<!--");
    EXPECT_EQ(
        complaint(write("bones.dae", replaced(bones, "<node id=\"eye\">", "--><node id=\"eye\">"))),
        "it holds no triangle");
}

/// What is noted of the file.
std::vector<std::string> notes_of(const std::filesystem::path& path) {
    return import_scene(path).file.notes;
}

TEST_F(AssimpFiles, DigitsThatFloatsLoseAreNoted) {
    // Floats are 2^-23 of their size apart, 0.5 at 5e6: of sqrt(2), the diagonal, 0.4.
    const std::string near = dae_file("<perspective/>");
    const auto moved = [&](const char* x) {
        return replaced(
            near, "0 0 0 1 0 0 0 1 0 1 1 0", fmt::format("{0} 0 0 {0} 1 0 {0} 0 1 {0} 1 1", x));
    };
    EXPECT_THAT(notes_of(write("near.dae", near)), IsEmpty());
    EXPECT_THAT(notes_of(write("edge.dae", moved("100"))), IsEmpty());
    EXPECT_THAT(notes_of(write("far.dae", moved("5000000.1"))),
                ElementsAre("digits of 2 objects far from zero: places are read as floats, there "
                            "up to 0.4 of the size apart"));
    EXPECT_THAT(notes_of(write("node.dae",
                               replaced(replaced(near, "<translate>0 0", "<translate>1e6 0"),
                                        "<translate>5 0",
                                        "<translate>1000005 0"))),
                ElementsAre(HasSubstr("digits of 2 objects")))
        << "the places of nodes are floats, too";
}

}  // namespace
}  // namespace ink::import
