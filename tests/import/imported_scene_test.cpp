// A reply of the import child is not trusted: whatever it claims must end in a sound scene or an
// Error.

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "import/printable.h"
#include "tests/import/imported_meshes.h"

namespace ink::import {
namespace {

std::string fault_in(ImportReply reply, std::uint64_t most_triangles = 1000) {
    try {
        (void)scene_from_reply(std::move(reply), "dir/cube.obj", most_triangles);
    } catch (const core::Error& error) {
        EXPECT_EQ(error.where(), "dir/cube.obj");
        return error.what_happened();
    }
    return {};
}

TEST(ImportedScene, SoundReplyIsTaken) {
    const scene::Scene scene = scene_from(cube_reply());
    EXPECT_EQ(scene.name, "cube");
    EXPECT_EQ(scene::triangle_count(scene), 12U);
}

TEST(ImportedScene, RefusesWhatDoesNotFitTogether) {
    ImportReply absent_mesh = cube_reply();
    absent_mesh.instances[0].mesh = 1;
    EXPECT_EQ(fault_in(absent_mesh), "its reader placed a mesh that it did not hand over");

    ImportReply absent_vertex = cube_reply();
    absent_vertex.meshes[0].triangles[3][1] = 8;
    EXPECT_EQ(fault_in(absent_vertex), "mesh 0: triangle 3 uses vertex 8");

    ImportReply not_placed = cube_reply();
    not_placed.instances.clear();
    EXPECT_EQ(fault_in(not_placed), "it holds no triangle");
}

TEST(ImportedScene, RefusesAbsurdNumbers) {
    ImportReply far_away = cube_reply();
    far_away.instances[0].world_from_object = glm::dmat4(1e70);
    EXPECT_NE(fault_in(far_away).find("its extent is"), std::string::npos);

    ImportReply lost = cube_reply();
    lost.instances[0].world_from_object[3][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(fault_in(lost), "instance 0: its transform is not finite");

    EXPECT_EQ(fault_in(cube_reply(), 11), "it holds 12 triangles");
    EXPECT_EQ(fault_in(cube_reply(), 12), "");
}

TEST(ImportedScene, RefusesMotionThatDoesNotFit) {
    ImportReply reply = cube_reply();
    scene::Animation motion;
    motion.duration_s = 1;
    motion.node_of_instance = {3};
    reply.animation = motion;
    EXPECT_EQ(fault_in(reply), "animation: an instance hangs on node 3");
    reply.animation->node_of_instance = {scene::kNoNode};
    EXPECT_EQ(fault_in(reply), "");
    reply.animation->vertex_frames.resize(7);
    EXPECT_EQ(fault_in(reply), "animation: 7 lists of frames for 1 meshes");
}

TEST(ImportedScene, CamerasMoveOnlyIfTheirNodesDo) {
    ImportReply reply = cube_reply();
    scene::Animation motion;
    motion.duration_s = 1;
    motion.node_of_instance = {scene::kNoNode};
    motion.nodes = {mover({0, 0, 0}, {1, 0, 0}, 1), scene::AnimatedNode{}, scene::AnimatedNode{}};
    motion.nodes[1].parent = 0;
    const auto camera = [](std::uint32_t node) {
        return ImportedCamera{"c", {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7, node};
    };
    ImportedCamera flat = camera(0);
    flat.fov_y_rad = 0;
    reply.animation = motion;
    reply.cameras = {flat, camera(1), camera(2), camera(scene::kNoNode)};
    ImportReply still = reply;
    still.cameras = {camera(2)};
    ImportReply lost = reply;
    lost.cameras[1].node = 3;
    EXPECT_EQ(fault_in(lost), "animation: a camera hangs on node 3");
    const scene::Scene scene = scene_from(reply);
    EXPECT_EQ(scene.cameras.size(), 3U) << "the one that cannot be is out of both lists";
    EXPECT_EQ(scene.animation->node_of_camera,
              (std::vector<std::uint32_t>{1, scene::kNoNode, scene::kNoNode}))
        << "the first moves by its parent";
    EXPECT_TRUE(scene_from(still).animation->node_of_camera.empty());
}

TEST(ImportedScene, MotionThatTakesNoTimeIsNone) {
    ImportReply reply = cube_reply();
    reply.animation = scene::Animation{};
    reply.animation->node_of_instance = {scene::kNoNode};
    EXPECT_EQ(scene_from(reply).animation, nullptr);
}

TEST(ImportedScene, WrongNumberOfNormalsCountsAsNone) {
    ImportReply reply = cube_reply();
    reply.meshes[0].normals = {{0, 0, 1}};
    EXPECT_TRUE(scene_from(reply).meshes[0].normals.empty());
}

TEST(ImportedScene, KeepsNamesOfAnyScript) {
    ImportReply reply = cube_reply();
    reply.instances[0].name = "\u5e73\u9762 Gr\u00f6\u00dfe\n\x1b[1m";
    reply.animation_names = {"\xc3"};
    reply.notes = {"two\nlines"};
    const scene::Scene scene = scene_from(reply);
    EXPECT_EQ(scene.instances[0].name, "\u5e73\u9762 Gr\u00f6\u00dfe ?[1m");
    EXPECT_EQ(scene.file.animation_names.at(0), "?");
    EXPECT_EQ(scene.file.notes.at(0), "two lines");
}

TEST(ImportedScene, CutsNoCharacterInTwo) {
    std::string umlauts;
    for (int i = 0; i < 20; ++i)
        umlauts += "\u00e4";
    const std::string cut = printable(umlauts, 20);
    EXPECT_EQ(cut.size(), 19U);
    EXPECT_TRUE(cut.ends_with("\u00e4..."));
    EXPECT_EQ(printable("\xed\xa0\x80 \xc0\x80 \xf4\x90\x80\x80", 80), "??? ?? ????")
        << "no characters";
}

TEST(ImportedScene, PartsBecomeMaterialsOfTriangles) {
    ImportReply reply = cube_reply();
    reply.meshes[0].parts = {{0, 4, 0, 0}, {10, 5, 1, 0}};
    ImportReply backwards = reply;
    backwards.meshes[0].parts[0].first_triangle = 1;
    ImportReply beyond = reply;
    beyond.meshes[0].parts[1].first_triangle = 13;
    EXPECT_EQ(fault_in(backwards), "its reader put the parts of a mesh out of order");
    EXPECT_EQ(fault_in(beyond), "its reader put a part of a mesh behind its end");
    const scene::Scene scene = scene_from(reply);
    EXPECT_EQ(scene.meshes[0].materials.at(9), 4U);
    EXPECT_EQ(scene.meshes[0].materials.at(10), 5U);
    EXPECT_EQ(scene_from(reply, true).instances.size(), 2U);
}

TEST(ImportedScene, KeepsCamerasThatLookSomewhereUnderDistinctNames) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    ImportReply reply = cube_reply();
    const ImportedCamera good{"a b", {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7};
    ImportedCamera nowhere = good;
    nowhere.target_world = nowhere.eye_world;
    ImportedCamera lost = good;
    lost.eye_world.x = kNan;
    ImportedCamera flat = good;
    flat.fov_y_rad = 0;
    ImportedCamera nameless = good;
    nameless.name = "";
    reply.cameras = {good, nowhere, lost, flat, good, nameless};
    const scene::Scene scene = scene_from(reply);
    ASSERT_EQ(scene.cameras.size(), 3U);
    EXPECT_EQ(scene.cameras[0].name, "a_b");
    EXPECT_EQ(scene.cameras[1].name, "a_b_2");
    EXPECT_EQ(scene.cameras[2].name, "camera");
    EXPECT_LT(scene.cameras[0].near, 5 - 1) << "the cube's front is not cut";
    EXPECT_GT(scene.cameras[0].far, 5 + 1);
}

TEST(Printable, OneShortPlainLine) {
    EXPECT_EQ(printable("a\nb\t\x1b[1m\xc3\xa9  ", 80), "a b ?[1m\xc3\xa9");
    EXPECT_EQ(printable("abcdefghij", 8), "abcde...");
    EXPECT_EQ(printable("", 8), "");
}

}  // namespace
}  // namespace ink::import
