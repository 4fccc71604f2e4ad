// KHR_lights_punctual on its way into a scene.

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "scene/animation.h"
#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using GltfLights = ModelFiles;

/// A cube with lights, each at a node of its own; the cube's is node 0.
GlbFile lit_file(const std::vector<Json>& lights, const std::vector<Json>& places) {
    GlbFile file = cube_file();
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = lights;
    file.put("nodes", {{"mesh", 0}});
    for (std::size_t l = 0; l < places.size(); ++l) {
        Json node = places[l];
        node["extensions"]["KHR_lights_punctual"]["light"] = l;
        file.json["scenes"][0]["nodes"].push_back(file.put("nodes", node));
    }
    return file;
}

TEST_F(GltfLights, HavePlaceColourAndRange) {
    const GlbFile file =
        lit_file({{{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}, {"range", 6}}},
                 {{{"translation", {0, 4, 0}}, {"scale", {3, 3, 3}}}});
    const scene::Scene scene = import_scene(write("lit.glb", file.bytes()));
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].p_world, glm::dvec3(0, 4, 0));
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5F, 0)) << "the brightest has full light";
    EXPECT_EQ(scene.lights[0].range, 6) << "nodes scale no light";
    EXPECT_TRUE(scene.file.notes.empty());
}

TEST_F(GltfLights, AreWhiteReachEverywhereAndOfOneCandelaUnlessSaid) {
    // Both 4.5 from the cube's middle: one candela counts for half of two.
    const GlbFile file =
        lit_file({{{"type", "point"}}, {{"type", "point"}, {"intensity", 2}}},
                 {{{"translation", {0.5, 5, 0.5}}}, {{"translation", {0.5, -4, 0.5}}}});
    const scene::Scene scene = import_scene(write("plain.glb", file.bytes()));
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(0.5F));
    EXPECT_EQ(scene.lights[1].color, glm::vec3(1));
    EXPECT_EQ(scene.lights[0].range, 0);
}

TEST_F(GltfLights, SunsShineAlongMinusZOfTheirNodesAndSpotsAreNoted) {
    const GlbFile file = lit_file({{{"type", "directional"}, {"range", 2}},
                                   {{"type", "spot"}, {"spot", Json::object()}},
                                   {{"type", "beam"}}},
                                  {{{"rotation", {-0.7071067811865476, 0, 0, 0.7071067811865476}}},
                                   {{"translation", {0, 9, 0}}},
                                   Json::object()});
    const scene::Scene scene = import_scene(write("sun.glb", file.bytes()));
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_GT(scene.lights[0].p_world.y, 500);
    EXPECT_EQ(scene.lights[0].range, 0);
    EXPECT_THAT(
        scene.file.notes,
        ElementsAre("a light of type 'beam' is not heeded", "1 spotlight shines to all sides"));
}

TEST_F(GltfLights, GoWithTheirNodes) {
    GlbFile file = lit_file({{{"type", "point"}}}, {{{"translation", {0, 4, 0}}}});
    animate(file, 1, "translation", file.accessor<float>({0, 4, 0, 6, 4, 0}, "VEC3"), {0, 2});
    scene::Scene scene = import_scene(write("moving.glb", file.bytes()));
    ASSERT_EQ(scene.lights.size(), 1U);
    scene::pose_scene(scene, 1);
    EXPECT_LT(glm::length(scene.lights[0].p_world - glm::dvec3(3, 4, 0)), 1e-12);
}

TEST_F(GltfLights, HiddenOnesAreNoneAndOnesThatAreNotThereAreRefused) {
    GlbFile hidden = lit_file({{{"type", "point"}}}, {Json::object()});
    hidden.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
    EXPECT_TRUE(import_scene(write("hidden.glb", hidden.bytes())).lights.empty());
    GlbFile lost = lit_file({{{"type", "point"}}}, {Json::object()});
    lost.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 3;
    EXPECT_THAT(complaint(write("lost.glb", lost.bytes())), HasSubstr("light is 3"));
}

}  // namespace
}  // namespace ink::import
