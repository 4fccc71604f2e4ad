#include "bake/used_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ink::bake {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::IsEmpty;
using Ranges = std::vector<ByteRange>;

TEST(UsedBytes, RangesWithoutOthers) {
    const Ranges all{{0, 10}, {20, 30}};
    EXPECT_EQ(without(all, {}), all);
    EXPECT_EQ(without(all, {{0, 40}}), Ranges{});
    EXPECT_EQ(without(all, {{2, 4}, {6, 22}, {29, 30}}), (Ranges{{0, 2}, {4, 6}, {22, 29}}));
    EXPECT_EQ(without(all, {{10, 20}}), all);
}

TEST(UsedBytes, AccessorsUseTheirOwnAllElseWholeViews) {
    Json gltf = {{"bufferViews",
                  {{{"buffer", 0}, {"byteOffset", 100}, {"byteLength", 400}},
                   {{"buffer", 0}, {"byteLength", 40}},
                   {{"buffer", 1}, {"byteLength", 40}},
                   {{"buffer", 0}, {"byteOffset", 600}, {"byteLength", 64}, {"byteStride", 16}}}},
                 {"accessors",
                  {{{"bufferView", 0},
                    {"byteOffset", 8},
                    {"componentType", 5126},
                    {"count", 3},
                    {"type", "VEC3"}},
                   {{"bufferView", 2}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}},
                   {{"bufferView", 3}, {"componentType", 5123}, {"count", 4}, {"type", "VEC2"}}}},
                 {"images", {{{"bufferView", 1}}, {{"uri", "a.png"}}}}};
    EXPECT_EQ(used_bytes(gltf, 0, 700), (Ranges{{0, 40}, {108, 144}, {600, 652}}));
    EXPECT_EQ(used_bytes(gltf, 0, 700, {1}), (Ranges{{108, 144}, {600, 652}}));
    // What cannot be understood might use anything.
    for (const Json& wrong : {Json(-1), Json("x"), Json(7), Json(nullptr)}) {
        Json damaged = gltf;
        damaged["images"][0]["bufferView"] = wrong;
        EXPECT_EQ(used_bytes(damaged, 0, 700), (Ranges{{0, 700}})) << wrong;
    }
    gltf["accessors"][0]["type"] = "MAT3";
    EXPECT_EQ(used_bytes(gltf, 0, 700), (Ranges{{0, 40}, {100, 500}, {600, 652}}));
}

TEST(UsedBytes, SparseAccessorsUseTheirViewsToo) {
    const Json gltf = {{"bufferViews",
                        {{{"buffer", 0}, {"byteLength", 4}},
                         {{"buffer", 0}, {"byteOffset", 8}, {"byteLength", 24}}}},
                       {"accessors",
                        {{{"componentType", 5126},
                          {"count", 9},
                          {"type", "VEC3"},
                          {"sparse",
                           {{"count", 2},
                            {"indices", {{"bufferView", 0}, {"componentType", 5121}}},
                            {"values", {{"bufferView", 1}}}}}}}}};
    EXPECT_EQ(used_bytes(gltf, 0, 40), (Ranges{{0, 4}, {8, 32}}));
}

TEST(UsedBytes, UsesOfAccessorsAreCounted) {
    const Json primitive = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
                            {"indices", 2},
                            {"targets", {{{"POSITION", 1}}}}};
    const Json gltf = {
        {"accessors", Json(Json::array_t(5, Json::object()))},
        {"meshes", {{{"primitives", {primitive, primitive}}}}},
        {"skins", {{{"inverseBindMatrices", 3}}}},
        {"animations", {{{"samplers", {{{"input", 3}, {"output", 99}}}}}}},
        {"nodes",
         {{{"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"SCALE", 4}}}}}}}}}}};
    EXPECT_THAT(accessor_uses(gltf), ElementsAre(2, 4, 2, 2, 1));
    EXPECT_THAT(accessor_uses(Json::object()), IsEmpty());
}

TEST(UsedBytes, UnknownExtensionsMayUseAnything) {
    EXPECT_TRUE(knows_all_references({{"asset", {}}}));
    EXPECT_TRUE(knows_all_references({{"extensionsUsed", {"KHR_materials_unlit"}}}));
    EXPECT_FALSE(knows_all_references({{"extensionsUsed", {"KHR_lights_punctual", "VENDOR_x"}}}));
    EXPECT_FALSE(knows_all_references({{"extensionsUsed", {1}}}));
}

}  // namespace
}  // namespace ink::bake
