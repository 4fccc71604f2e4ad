#include "import/scene_stream.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/import/imported_meshes.h"

namespace ink::import {
namespace {

using Bytes = std::vector<std::byte>;

const std::vector<glm::vec3> kFramePositions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

ImportReply sample_reply() {
    ImportReply reply;
    ImportedMesh mesh;
    mesh.name = "mesh";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
    mesh.marked_sides = {0b101, 0};
    mesh.parts = {{0, 5, 1, 0}, {1, 6, 2, 1}};
    mesh.are_floats = true;
    reply.meshes = {mesh, ImportedMesh{}};
    reply.instances = {
        {.mesh = 0, .world_from_object = glm::dmat4(2), .name = "node", .file_node = 7}};
    reply.animation_names = {"walk", ""};
    reply.notes = {"a lamp"};
    reply.base_colors = {{1, 0.5, 0, 1}, {0, 0, 1, 0.5}};
    reply.lights.resize(2);
    reply.lights[1] = {.kind = LightKind::distant,
                       .p_world = {1, 2, 3},
                       .direction_world = {4, 5, 6},
                       .color = {7, 8, 9},
                       .is_physical = true,
                       .range = 10,
                       .inner_range = 11,
                       .node = 12,
                       .colors = {{13, {1, 1, 1}}}};
    reply.cameras = {{.name = "eye",
                      .eye_world = {1, 2, 3},
                      .fov_y_rad = 0.5,
                      .motion = {1, 0, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}};
    scene::Animation motion;
    motion.duration_s = 3;
    motion.frames_per_s = 10;
    scene::AnimatedNode node;
    node.translations = {{0, {1, 2, 3}}, {1, {4, 5, 6}}};
    node.rotations = {{0.5, {0, 1, 0, 0}}};
    node.scales = {{0, {1, 1, 1}}};
    motion.nodes = {node, scene::AnimatedNode{}};
    motion.node_of_instance = {1};
    motion.vertex_frames = {{2, kFramePositions, mesh.normals}, {}};
    scene::Skin skin{1, {}, {}, {{1, glm::dmat4(3)}}, {}, {}};
    scene::set_weights({{{0, 0.5F}}, {}, {{0, 1}}}, skin);
    motion.skins = {skin};
    scene::Morph morph;
    morph.targets.resize(2);
    morph.targets[1] = {.positions = kFramePositions,
                        .normals = mesh.normals,
                        .weight = 0.25,
                        .weights = {{0, 1}, {1, 2}},
                        .course = {scene::Interpolation::cubic, {{1, 2}, {3, 4}}}};
    motion.morphs = {morph};
    reply.animation = motion;
    return reply;
}

TEST(SceneStream, GivesBackWhatWasWritten) {
    const auto reply = read_reply(stream_of(sample_reply()));
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(reply->status, ImportStatus::scene);
    ASSERT_EQ(reply->meshes.size(), 2U);
    const ImportedMesh expected = sample_reply().meshes[0];
    EXPECT_EQ(reply->meshes[0].name, expected.name);
    EXPECT_EQ(reply->meshes[0].positions, expected.positions);
    EXPECT_EQ(reply->meshes[0].normals, expected.normals);
    EXPECT_EQ(reply->meshes[0].triangles, expected.triangles);
    EXPECT_EQ(reply->meshes[0].marked_sides, expected.marked_sides);
    ASSERT_EQ(reply->meshes[0].parts.size(), 2U);
    EXPECT_EQ(reply->meshes[0].parts[1].first_triangle, 1U);
    EXPECT_EQ(reply->meshes[0].parts[1].material, 6U);
    EXPECT_EQ(reply->meshes[0].parts[1].primitive, 2U);
    EXPECT_EQ(reply->meshes[0].parts[1].first_vertex, 1U);
    EXPECT_TRUE(reply->meshes[0].are_floats);
    EXPECT_FALSE(reply->meshes[1].are_floats);
    ASSERT_EQ(reply->instances.size(), 1U);
    EXPECT_EQ(reply->instances[0].world_from_object, glm::dmat4(2));
    EXPECT_EQ(reply->instances[0].name, "node");
    EXPECT_EQ(reply->instances[0].file_node, 7U);
    EXPECT_EQ(reply->animation_names, sample_reply().animation_names);
    EXPECT_EQ(reply->notes, sample_reply().notes);
    EXPECT_EQ(reply->base_colors, sample_reply().base_colors);
    ASSERT_EQ(reply->lights.size(), 2U);
    EXPECT_EQ(reply->lights[0].kind, LightKind::point);
    EXPECT_FALSE(reply->lights[0].is_physical);
    EXPECT_EQ(reply->lights[1].kind, LightKind::distant);
    EXPECT_EQ(reply->lights[1].p_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(reply->lights[1].direction_world, glm::dvec3(4, 5, 6));
    EXPECT_EQ(reply->lights[1].color, glm::vec3(7, 8, 9));
    EXPECT_TRUE(reply->lights[1].is_physical);
    EXPECT_EQ(reply->lights[1].range, 10);
    EXPECT_EQ(reply->lights[1].inner_range, 11);
    EXPECT_EQ(reply->lights[1].node, 12U);
    ASSERT_EQ(reply->lights[1].colors.size(), 1U);
    EXPECT_EQ(reply->lights[1].colors[0].time_s, 13);
    ASSERT_EQ(reply->cameras.size(), 1U);
    EXPECT_EQ(reply->cameras[0].name, "eye");
    EXPECT_EQ(reply->cameras[0].eye_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(reply->cameras[0].fov_y_rad, 0.5);
}

TEST(SceneStream, GivesBackTheMotion) {
    const auto reply = read_reply(stream_of(sample_reply()));
    ASSERT_TRUE(reply.has_value() && reply->animation.has_value());
    const scene::Animation& motion = *reply->animation;
    EXPECT_EQ(motion.duration_s, 3);
    EXPECT_EQ(motion.frames_per_s, 10);
    ASSERT_EQ(motion.nodes.size(), 2U);
    ASSERT_EQ(motion.nodes[0].translations.size(), 2U);
    EXPECT_EQ(motion.nodes[0].translations[1].value, glm::dvec3(4, 5, 6));
    EXPECT_EQ(motion.nodes[0].rotations.at(0).time_s, 0.5);
    EXPECT_EQ(motion.nodes[0].rotations.at(0).value, glm::dquat(0, 1, 0, 0));
    EXPECT_EQ(motion.nodes[0].scales.size(), 1U);
    EXPECT_FALSE(motion.nodes[1].has_keys());
    EXPECT_EQ(motion.node_of_instance, std::vector<std::uint32_t>{1});
    ASSERT_EQ(motion.vertex_frames.size(), 2U);
    EXPECT_EQ(motion.vertex_frames[0].frame_count, 2U);
    EXPECT_EQ(motion.vertex_frames[0].positions, kFramePositions);
    ASSERT_EQ(motion.skins.size(), 1U);
    EXPECT_EQ(motion.skins[0].mesh, 1U);
    EXPECT_EQ(motion.skins[0].bones.at(0).node_from_mesh, glm::dmat4(3));
    EXPECT_EQ(motion.skins[0].first_weight, (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_EQ(motion.skins[0].weights.at(1).weight, 1);
    ASSERT_EQ(motion.morphs.size(), 1U);
    const scene::Morph::Target& target = motion.morphs[0].targets.at(1);
    EXPECT_EQ(target.positions, kFramePositions);
    EXPECT_EQ(target.normals, sample_reply().meshes[0].normals);
    EXPECT_EQ(target.weight, 0.25);
    EXPECT_EQ(target.weights.at(1).value, 2);
    EXPECT_EQ(target.course.interpolation, scene::Interpolation::cubic);
    EXPECT_EQ(target.course.tangents.at(1).in, 3);
}

TEST(SceneStream, CutAnywhereIsNoReply) {
    const Bytes whole = stream_of(sample_reply());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(read_reply(std::span(whole).first(size)).has_value()) << size;
    }
}

TEST(SceneStream, MoreThanOneReplyIsNone) {
    Bytes stream = stream_of(sample_reply());
    stream.push_back(std::byte{0});
    EXPECT_FALSE(read_reply(stream).has_value());
}

TEST(SceneStream, AnyCountMayLie) {
    // A count blown up at any place must neither be believed nor allocated.
    const Bytes whole = stream_of(sample_reply());
    int refused = 0;
    for (std::size_t at = 0; at + 8 <= whole.size(); ++at) {
        Bytes damaged = whole;
        std::memset(damaged.data() + at, 0x7f, 8);
        refused += read_reply(damaged).has_value() ? 0 : 1;
    }
    EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace ink::import
