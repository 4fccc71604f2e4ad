#include "import/scene_stream.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/whole_file.h"
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
    mesh.texcoords = {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}};
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
                       .node = 12};
    reply.cameras = {{.name = "eye", .eye_world = {1, 2, 3}, .fov_y_rad = 0.5, .node = 1}};
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

// Every field of the sample has a value of its own, so what is lost or taken for another's changes
// the bytes. What is never written, the tests of the readers miss.
TEST(SceneStream, WhatWasReadIsWrittenAsItWas) {
    const Bytes whole = stream_of(sample_reply());
    const auto reply = read_reply(whole);
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(reply->status, ImportStatus::scene);
    EXPECT_EQ(stream_of(*reply), whole);
    EXPECT_EQ(reply->meshes.at(0).positions, sample_reply().meshes[0].positions);
    EXPECT_EQ(reply->meshes[0].texcoords, sample_reply().meshes[0].texcoords);
    EXPECT_EQ(reply->meshes[0].marked_sides, sample_reply().meshes[0].marked_sides);
    EXPECT_EQ(reply->meshes[0].parts.at(1).primitive, 2U);
    EXPECT_EQ(reply->instances.at(0).file_node, 7U);
    EXPECT_EQ(reply->notes, sample_reply().notes);
    EXPECT_EQ(reply->lights.at(1).node, 12U);
    EXPECT_EQ(reply->cameras.at(0).node, 1U);
    ASSERT_TRUE(reply->animation.has_value());
    const scene::Animation& motion = *reply->animation;
    EXPECT_EQ(motion.nodes.at(0).rotations.at(0).value, glm::dquat(0, 1, 0, 0));
    EXPECT_EQ(motion.vertex_frames.at(0).positions, kFramePositions);
    EXPECT_EQ(motion.skins.at(0).first_weight, (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_EQ(motion.morphs.at(0).targets.at(1).course.tangents.at(1).in, 3);
}

TEST(SceneStream, WhatFuzzersBeginWithIsRead) {
    for (const char* name : {"still", "moving"}) {
        const auto file = core::read_whole_file(
            std::string(INK_SOURCE_DIR "/tests/fuzz/corpus/scene_stream/") + name);
        const std::string text = file.value_or("");
        EXPECT_TRUE(read_reply(std::as_bytes(std::span(text))).has_value()) << name;
    }
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
