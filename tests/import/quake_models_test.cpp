#include "import/quake_models.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <set>

#include "import/imported_scene.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using QuakeModel = ModelFiles;
using QuakeModelRefuses = ModelFiles;

ModelBytes model_bytes(const std::string& text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {"", {first, first + text.size()}};
}

glm::dvec3 corner(const scene::Scene& scene, std::size_t instance, std::size_t vertex) {
    const scene::Instance& placed = scene.instances.at(instance);
    return scene::to_world(placed, scene.meshes.at(placed.mesh).positions.at(vertex));
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(found - expected), 1e-6) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(QuakeNormals, AreUnitAndDiffer) {
    std::set<std::array<float, 3>> all;
    for (std::size_t i = 0; i < kQuakeNormals; ++i) {
        const glm::vec3 n = quake_normal(i);
        EXPECT_NEAR(glm::length(n), 1, 2e-6) << i;
        all.insert({n.x, n.y, n.z});
    }
    EXPECT_EQ(all.size(), 162U);
    EXPECT_EQ(quake_normal(5), glm::vec3(0, 0, 1));
    EXPECT_EQ(quake_normal(32), glm::vec3(0, 1, 0));
    EXPECT_EQ(quake_normal(52), glm::vec3(1, 0, 0));
}

TEST_F(QuakeModel, MdlGivesAllFramesPlainOrGrouped) {
    for (const bool is_grouped : {false, true}) {
        scene::Scene scene = import_scene(write("three.mdl", mdl_file(is_grouped)));
        ASSERT_NE(scene.animation, nullptr);
        EXPECT_EQ(scene.animation->frame_count(), 3U);
        EXPECT_DOUBLE_EQ(scene.animation->duration_s, 0.2);
        EXPECT_THAT(scene.meshes[0].triangles, ElementsAre(scene::Triangle{2, 1, 0}))
            << "clockwise in the file";
        for (int f = 0; f < 3; ++f) {
            scene::pose_scene(scene, scene.animation->frame_time_s(static_cast<std::size_t>(f)));
            const double height = 3 + 8 * f;  // 4 steps of 2 a frame
            EXPECT_THAT(
                scene.meshes[0].positions,
                ElementsAre(
                    glm::vec3(-1, 0, height), glm::vec3(4, 0, height), glm::vec3(-1, 5, height)));
            EXPECT_EQ(corner(scene, 0, 2), glm::dvec3(-1, height, -5)) << "z up becomes y up";
        }
    }
}

TEST_F(QuakeModel, Md2GivesAllFrames) {
    scene::Scene scene = import_scene(write("two.md2", md2_file()));
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_EQ(scene.animation->frame_count(), 2U);
    EXPECT_THAT(scene.meshes[0].triangles, ElementsAre(scene::Triangle{2, 1, 0}));
    EXPECT_EQ(scene.meshes[0].normals[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(corner(scene, 0, 1), glm::dvec3(4, 3, 0));
    scene::pose_scene(scene, 0.1);
    EXPECT_EQ(corner(scene, 0, 1), glm::dvec3(4, 11, 0));
}

TEST_F(QuakeModel, OneFrameIsNoAnimation) {
    const scene::Scene scene = import_scene(write("one.md3", md3_file(1, "tag_x")));
    EXPECT_EQ(scene.animation, nullptr);
    EXPECT_EQ(corner(scene, 0, 2), glm::dvec3(0, 0, -2));
}

TEST_F(QuakeModel, Md3PartsHangOnTheirTagsInEveryFrame) {
    (void)write("lower.md3", md3_file(3, "tag_torso"));
    (void)write("head.md3", md3_file(1, "tag_x"));
    scene::Scene scene = import_scene(write("upper.md3", md3_file(2, "tag_head")));
    ASSERT_EQ(scene.instances.size(), 3U);
    EXPECT_EQ(scene.instances[0].name, "lower/skin");
    EXPECT_EQ(scene.instances[2].name, "head/skin");
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_EQ(scene.animation->frame_count(), 3U);
    expect_near(corner(scene, 1, 0), {0, 5, 0});
    expect_near(corner(scene, 2, 1), {1, 10, 0});
    scene::pose_scene(scene, scene.animation->frame_time_s(1));
    expect_near(corner(scene, 0, 1), {1, 1, 0});
    expect_near(corner(scene, 1, 1), {0, 7, -1});
    expect_near(corner(scene, 2, 1), {-1, 12, 0});
    // The upper part has no third frame and keeps its second.
    scene::pose_scene(scene, scene.animation->frame_time_s(2));
    expect_near(corner(scene, 0, 1), {1, 2, 0});
    expect_near(corner(scene, 1, 1), {1, 8, 0});
    expect_near(corner(scene, 2, 1), {0, 13, -1});
}

TEST_F(QuakeModel, Md3PartAloneIsItself) {
    const scene::Scene scene = import_scene(write("lower.md3", md3_file(2, "tag_torso")));
    EXPECT_EQ(scene.instances.size(), 1U);
}

TEST_F(QuakeModelRefuses, WrongNumbersByTheirPlace) {
    const auto mdl_with = [&](std::size_t offset, std::int32_t value) {
        std::string bytes = mdl_file();
        put_at(bytes, offset, value);
        return complaint(write("bad.mdl", bytes));
    };
    EXPECT_EQ(mdl_with(68, 0), "is damaged; byte 68: 0 frames (accepted: 1 or more)");
    EXPECT_EQ(mdl_with(60, -7), "is damaged; byte 60: -7 vertices (accepted: 1 or more)");
    EXPECT_THAT(mdl_with(64, 1 << 30), HasSubstr("1073741824 triangles do not fit into the file"));
    EXPECT_THAT(mdl_with(48, 1 << 30), HasSubstr("byte "));
    std::string md2 = md2_file();
    put_at<std::uint16_t>(md2, 68 + 2, 3);
    EXPECT_EQ(complaint(write("bad.md2", md2)),
              "is damaged; byte 70: a triangle of vertex 3 (accepted: 0..2)");
    md2 = md2_file();
    put_at<std::uint8_t>(md2, 80 + 40 + 3, 162);
    EXPECT_EQ(complaint(write("bad.md2", md2)),
              "is damaged; byte 123: normal 162 (accepted: 0..161)");
    md2 = md2_file();
    put_at<float>(md2, 80, std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(complaint(write("bad.md2", md2)), "mesh 0: vertex 0 is not finite");
    (void)write("lower.md3", md3_file(2, "tag_torso"));
    (void)write("upper.md3", md3_file(2, "tag_neck"));
    (void)write("head.md3", md3_file(1, "tag_x"));
    EXPECT_EQ(
        complaint(in_folder("lower.md3")),
        "is damaged; upper.md3, byte 80: 1 tags, none called tag_head (accepted: a tag of that "
        "name)");
}

/// Reads a damaged file as the import does; whatever it holds must be a sound scene or an Error.
template <class Read>
bool is_refused(const std::string& bytes, Read read) {
    try {
        scene::Scene scene = scene_from_reply(read(model_bytes(bytes)), "made/up", 1000);
        scene::pose_scene(scene, 0.05);
        return false;
    } catch (const core::Error&) {
        return true;
    }
}

template <class Read>
void expect_no_crash(const std::string& whole, Read read) {
    EXPECT_FALSE(is_refused(whole, read));
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); ++size)
        refused += is_refused(whole.substr(0, size), read) ? 1 : 0;
    EXPECT_GT(refused, static_cast<int>(whole.size() * 9 / 10));
    std::uint32_t state = 1;
    const auto chance = [&] { return (state = state * 1664525 + 1013904223) >> 8; };
    for (int i = 0; i < 20000; ++i) {
        std::string bytes = whole;
        for (std::uint32_t n = chance() % 4 + 1; n > 0; --n) {
            const std::size_t at = chance() % (bytes.size() - 4);
            constexpr std::int32_t kEvil[] = {-1, 0, 1, 0x7fffffff, -0x7fffffff, 0x7fc00000, 255};
            const bool is_evil = chance() % 2 == 0;
            if (is_evil) put_at(bytes, at, kEvil[chance() % std::size(kEvil)]);
            if (!is_evil) bytes[at] = static_cast<char>(chance());
        }
        refused += is_refused(bytes, read) ? 1 : 0;
    }
    EXPECT_GT(refused, 2000);
}

TEST(QuakeModelDamage, NeverCrashesAReader) {
    for (const bool is_grouped : {false, true})
        expect_no_crash(mdl_file(is_grouped), [](ModelBytes file) { return read_mdl(file, "x"); });
    expect_no_crash(md2_file(), [](ModelBytes file) { return read_md2(file, "x"); });
    expect_no_crash(md3_file(3, "tag_torso"), [](ModelBytes file) {
        return read_md3({{"lower", file},
                         {"upper", model_bytes(md3_file(2, "tag_head"))},
                         {"head", model_bytes(md3_file(1, "tag_x"))}});
    });
}

}  // namespace
}  // namespace ink::import
