// Files that are wrong, hostile, or ask for what is not read: one line that names the place.

#include <gmock/gmock.h>

#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::HasSubstr;
using GltfRefuses = ModelFiles;

/// A sound file with a sparse accessor, a skin, a morph target and an animation.
GlbFile whole_file() {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["JOINTS_0"] = file.accessor(std::vector<std::uint8_t>(32, 0), "VEC4");
    std::vector<float> weights(32, 0);
    for (std::size_t v = 0; v < 8; ++v)
        weights[4 * v] = 1;
    primitive["attributes"]["WEIGHTS_0"] = file.accessor(weights, "VEC4");
    primitive["targets"] = {{{"POSITION", file.accessor(std::vector<float>(24, 0), "VEC3")}}};
    file.put("nodes", {{"mesh", 0}, {"skin", 0}});
    file.put("nodes", {{"name", "joint"}, {"translation", {0, 0, 0}}});
    file.put("skins", {{"joints", {1}}});
    animate(file, 1, "translation", file.accessor<float>({0, 0, 0, 1, 0, 0}, "VEC3"), {0, 1});
    return file;
}

TEST_F(GltfRefuses, WrongNumbersByTheirPlace) {
    ASSERT_EQ(scene::triangle_count(import_scene(write("whole.glb", whole_file().bytes()))), 12U);
    const std::vector<std::tuple<const char*, Json, const char*>> wrong = {
        {"/accessors/0/count",
         9,
         "is damaged; accessor 0: count is 9 (accepted: 0..8 in bufferView 0)"},
        {"/accessors/0/count", 4294967295, "accessor 0: count is 4294967295"},
        {"/accessors/0/count", -1, "accessor 0: count is -1"},
        {"/accessors/0/count", "8", "accessor 0: count is \"8\""},
        {"/accessors/0/byteOffset", 1, "accessor 0: count is 8"},
        {"/accessors/0/componentType",
         5125,
         "accessor 0: componentType is 5125 (accepted: 5120, 5121, 5122, 5123, "
         "5126 for POSITION)"},
        {"/accessors/0/type", "VEC2", "accessor 0: type is VEC2"},
        {"/accessors/0/bufferView", 99, "accessor 0: bufferView is 99"},
        {"/bufferViews/0/byteLength", 99999, "bufferView 0: byteLength is 99999"},
        {"/bufferViews/0/byteStride", 8, "bufferView 0: byteStride is 8"},
        {"/bufferViews/0/buffer", 1, "bufferView 0: buffer is 1"},
        {"/meshes/0/primitives/0/mode", 7, "mesh 0, primitive 0: mode is 7"},
        {"/meshes/0/primitives/0/attributes/POSITION",
         44,
         "mesh 0, primitive 0, attributes: POSITION is 44"},
        {"/meshes/0/primitives/0/attributes/JOINTS_0", 3, "accessor 3: componentType is 5126"},
        {"/nodes/0/mesh", 3, "node 0: mesh is 3"},
        {"/nodes/0/skin", 3, "node 0: skin is 3"},
        {"/nodes/0/rotation", {0, 0, 0, 0}, "node 0: a rotation of length 0"},
        {"/nodes/0/translation", {0, 0}, "node 0: translation is a list of 2"},
        {"/nodes/0/weights", {0, 0}, "node 0: weights is a list of 2"},
        {"/skins/0/joints", {7}, "skin 0: joints is 7"},
        {"/skins/0/inverseBindMatrices", 0, "accessor 0: type is VEC3"},
        {"/animations/0/channels/0/sampler", 1, "animation 0, channel 0: sampler is 1"},
        {"/animations/0/channels/0/target/node", 2, "animation 0, channel 0, target: node is 2"},
        {"/animations/0/samplers/0/interpolation",
         "CUBICSPLINE",
         "animation 0, channel 0: its keys have 6 numbers (accepted: 18)"},
        {"/scene", 1, "scene is 1"},
        {"/nodes", 5, "nodes is 5 (accepted: a list)"}};
    for (const auto& [pointer, value, message] : wrong) {
        GlbFile file = whole_file();
        file.json[Json::json_pointer(pointer)] = value;
        EXPECT_THAT(complaint(write("wrong.glb", file.bytes())), HasSubstr(message)) << pointer;
    }
}

TEST_F(GltfRefuses, IndicesBeyondTheVertices) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    file.json["meshes"][0]["primitives"][0]["indices"] =
        file.accessor<std::uint8_t>({0, 1, 2, 0, 1, 8}, "SCALAR");
    EXPECT_EQ(complaint(write("index.glb", file.bytes())),
              "is damaged; mesh 0, primitive 0: index 5 is 8 (accepted: below 8, the vertices)");
}

TEST_F(GltfRefuses, ZerosThatNoFileHolds) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    file.json["accessors"][0].erase("bufferView");
    file.json["accessors"][0]["count"] = 4000000000;
    EXPECT_THAT(complaint(write("zeros.glb", file.bytes())),
                HasSubstr("accessor 0: count of zeros is 4000000000"));
}

TEST_F(GltfRefuses, NodesThatAreNoTree) {
    const auto with = [&](const Json& nodes) {
        GlbFile file = cube_file();
        file.json["nodes"] = nodes;
        return complaint(write("tree.glb", file.bytes()));
    };
    EXPECT_THAT(with({{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}}),
                HasSubstr("node 1: it is below one of its own children"));
    EXPECT_THAT(with({{{"mesh", 0}, {"children", {1}}}, Json::object(), {{"children", {1}}}}),
                HasSubstr("node 1: it is a child of node 0 and of node 2"));
    EXPECT_THAT(with({{{"mesh", 0}}, {{"children", {0}}}}),
                HasSubstr("scene 0: node 0 is a child of node 1"));
}

TEST_F(GltfRefuses, DeepTreesAndDeepJson) {
    GlbFile file = cube_file();
    constexpr int kDeep = 100'000;
    Json nodes = Json::array();
    for (int n = 0; n + 1 < kDeep; ++n)
        nodes.push_back({{"children", {n + 1}}});
    nodes.push_back({{"mesh", 0}});
    file.json["nodes"] = nodes;
    EXPECT_EQ(scene::triangle_count(import_scene(write("deep.glb", file.bytes()))), 12U);
    const std::string deep(kDeep, '[');
    EXPECT_THAT(complaint(write("deep.gltf", "{\"asset\":" + deep)), HasSubstr("nested too deep"));
}

TEST_F(GltfRefuses, ChunksThatDoNotFit) {
    const std::string whole = whole_file().bytes();
    std::string bytes = whole;
    bytes.replace(12, 4, GlbFile::word(1'000'000));
    EXPECT_THAT(complaint(write("chunk.glb", bytes)),
                HasSubstr("byte 12: a chunk of 1000000 bytes"));
    bytes = whole;
    bytes.replace(16, 4, "JSOM");
    EXPECT_THAT(complaint(write("chunk.glb", bytes)), HasSubstr("byte 12: a chunk out of order"));
    bytes = whole;
    bytes.replace(20, 1, "[");
    EXPECT_THAT(complaint(write("json.glb", bytes)), HasSubstr("its JSON has a parse error"));
    EXPECT_THAT(complaint(write("huge.gltf", "{\"asset\":1e999}")),
                HasSubstr("its JSON has a number overflow"));
}

TEST_F(GltfRefuses, OtherVersionsByName) {
    GlbFile file = cube_file();
    file.json["asset"]["version"] = "1.0";
    EXPECT_EQ(complaint(write("old.gltf", file.json.dump())),
              "asset: glTF 1.0 is not read (accepted: glTF 2.0)");
    file.json["asset"] = {{"version", "2.0"}, {"minVersion", "2.1"}};
    EXPECT_EQ(complaint(write("new.gltf", file.json.dump())),
              "asset: it needs glTF 2.1 (accepted: glTF 2.0)");
}

TEST_F(GltfRefuses, ExtensionsItDoesNotKnowIfTheyAreRequired) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    file.json["extensionsUsed"] = {"EXT_unheard_of", "KHR_texture_transform", "KHR_materials_ior"};
    const scene::Scene scene = import_scene(write("used.glb", file.bytes()));
    EXPECT_THAT(scene.file.notes, testing::ElementsAre("not read: EXT_unheard_of"));
    file.json["extensionsRequired"] = {"KHR_texture_transform"};
    EXPECT_EQ(scene::triangle_count(import_scene(write("used.glb", file.bytes()))), 12U);
    file.json["extensionsRequired"] = {"EXT_unheard_of"};
    EXPECT_EQ(complaint(write("needed.glb", file.bytes())),
              "it needs the extension EXT_unheard_of, which is not read");
}

TEST_F(GltfRefuses, EveryFileCutShort) {
    const std::string whole = whole_file().bytes();
    for (std::size_t size = 1; size < whole.size(); size += 97)
        EXPECT_NE(complaint(write("cut.glb", whole.substr(0, size))), "") << size;
}

}  // namespace
}  // namespace ink::import
