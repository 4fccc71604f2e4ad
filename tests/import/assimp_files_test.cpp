// What is made of Assimp's scenes.

#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "import/assimp/fbx.h"
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

struct Box {
    glm::dvec3 low{1e30};
    glm::dvec3 high{-1e30};
};

Box box_of(const scene::Scene& scene) {
    Box box;
    for (const scene::Instance& instance : scene.instances)
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
            box.low = glm::min(box.low, glm::dvec3(scene::to_world(instance, p)));
            box.high = glm::max(box.high, glm::dvec3(scene::to_world(instance, p)));
        }
    return box;
}

TEST_F(AssimpFiles, FbxAxesAreHeeded) {
    const auto expect_box =
        [&](const FbxFile& file, const glm::dvec3& low, const glm::dvec3& high) {
            const Box box = box_of(import_scene(write("box.fbx", file.text())));
            EXPECT_LT(glm::length(box.low - low), 1e-6);
            EXPECT_LT(glm::length(box.high - high), 1e-6);
        };
    expect_box({}, {0, 0, 0}, {1, 2, 3});
    const FbxFile z_up{.up = 2, .front = 1, .front_sign = -1};
    expect_box(z_up, {0, 0, -2}, {1, 3, 0});
    const FbxFile x_up{.up = 0, .front = 2, .front_sign = -1, .right = 1};
    expect_box(x_up, {-2, 0, 0}, {0, 1, 3});
    const FbxFile inches{.unit = 2.54};
    expect_box(inches, {0, 0, 0}, {2.54, 5.08, 7.62});
}

TEST(FbxAxes, TurnUpToYAndKeepTheHand) {
    for (int up = 0; up < 3; ++up)
        for (const int up_sign : {-1, 1})
            for (const int front_sign : {-1, 1})
                for (const int right_sign : {-1, 1}) {
                    const FbxAxes axes{.up = {up, up_sign},
                                       .front = {(up + 1) % 3, front_sign},
                                       .right = {(up + 2) % 3, right_sign}};
                    const glm::dmat3 turn(y_up_from_fbx(axes));
                    glm::dvec3 up_in_file{0};
                    up_in_file[up] = up_sign;
                    EXPECT_EQ(turn * up_in_file, glm::dvec3(0, 1, 0));
                    // Right, up and front are x, y and z turned, or mirrored.
                    const bool is_left_handed = up_sign * front_sign * right_sign < 0;
                    EXPECT_EQ(glm::determinant(turn), is_left_handed ? -1 : 1);
                }
}

TEST(FbxAxes, ThoseThatAreNoneChangeNothing) {
    EXPECT_EQ(y_up_from_fbx({.up = {7, 1}, .cm_per_unit = -3}), glm::dmat4(1));
    EXPECT_EQ(y_up_from_fbx({.right = {1, 1}}), glm::dmat4(1)) << "two are the same";
}

TEST_F(AssimpFiles, OrthographicCamerasOfFbxAreAsHighAsTheirZoom) {
    const auto height = [&](const FbxFile& file) {
        const scene::Scene scene = import_scene(write("cam.fbx", file.text()));
        EXPECT_EQ(scene.cameras.size(), 1U);
        return scene.cameras.at(0).height_world;
    };
    EXPECT_EQ(height({.camera = 0}), 0) << "a pinhole";
    EXPECT_NEAR(height({.camera = 1}), 30, 1e-9);
    EXPECT_NEAR(height({.camera = 1, .zoom = 0.25}), 7.5, 1e-9);
    EXPECT_NEAR(height({.unit = 2.54, .camera = 1, .zoom = 0.25}), 19.05, 1e-6) << "in cm";
}

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

TEST(FbxCameras, AreFoundInBinaryFiles) {
    const auto text = [](const std::string& words) {
        std::string bytes = "S";
        put(bytes, static_cast<std::uint32_t>(words.size()));
        return bytes + words;
    };
    const auto number = [](std::int64_t value) {
        std::string bytes = "L";
        put(bytes, value);
        return bytes;
    };
    std::string file = "Kaydara FBX Binary  " + std::string(1, '\0') + "\rNodeAttribute" +
                       number(300) + text("") + text("Camera") + "\1P" +
                       text("CameraProjectionType") + text("enum") + text("") + text("") + "I";
    put(file, std::int32_t{1});
    file += "\1P" + text("OrthoZoom") + text("double") + text("Number") + text("A") + "D";
    put(file, 0.5);
    file += "\5Model" + number(400) + text(std::string("Eye\0\1Model", 10)) + text("Camera") +
            "\1C" + text("OO") + number(300) + number(400);
    EXPECT_THAT(read_fbx_parallel_cameras(file), ElementsAre(testing::Pair("Eye", 15)));
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_THAT(read_fbx_parallel_cameras(file.substr(0, size)), IsEmpty()) << size;
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
    const std::string fbx = FbxFile{}.text();
    EXPECT_THAT(notes_of(write("near.fbx", fbx)), IsEmpty());
    EXPECT_THAT(notes_of(write("far.fbx",
                               replaced(fbx,
                                        "a: 0,0,0,0,0,3,0,2,0,0,2,3,1,0,0,1,0,3,1,2,0,1,2,3",
                                        "a: 1e6,0,0,1e6,0,3,1e6,2,0,1e6,2,3,1000001,0,0,1000001,0,"
                                        "3,1000001,2,0,1000001,2,3"))),
                ElementsAre(HasSubstr("digits of 1 object far")));
}

}  // namespace
}  // namespace ink::import
