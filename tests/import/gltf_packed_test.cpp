// Meshes that meshoptimizer and Draco have packed come out as they went in.

#include <gmock/gmock.h>
#include <meshoptimizer.h>

#include <glm/geometric.hpp>

#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"
#include "tests/import/packed_files.h"
#include "tests/import/solids.h"

namespace ink::import {
namespace {

using testing::HasSubstr;
using GltfPacked = ModelFiles;

void expect_cube(const scene::Scene& scene) {
    expect_box(solid_of(scene), {0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(scene::triangle_count(scene), 12U);
}

TEST_F(GltfPacked, MeshoptStreamsOfEveryMode) {
    const Packed rows = packed_rows(cube_corners<float>(), 8);
    for (const bool is_sequence : {false, true}) {
        const GlbFile file = meshopt_cube(rows, {{"mode", "ATTRIBUTES"}}, is_sequence);
        const scene::Scene scene = import_scene(write("cube.glb", file.bytes()));
        expect_cube(scene);
        EXPECT_EQ(scene.meshes[0].positions[3], glm::vec3(1, 1, 0)) << "in the file's order";
    }
}

TEST_F(GltfPacked, MeshoptFilters) {
    // A word is a mantissa of 24 bits and an exponent of 8: that of 0 and 1 may be 0.
    const auto rows = cube_corners<std::uint32_t>();
    GlbFile file = meshopt_cube(
        packed_rows(rows, 8), {{"mode", "ATTRIBUTES"}, {"filter", "EXPONENTIAL"}}, false);
    // A normal along y for each corner.
    std::vector<float> up;
    for (int v = 0; v < 8; ++v)
        up.insert(up.end(), {0, 1, 0, 0});
    std::vector<std::int16_t> normals(32);
    meshopt_encodeFilterOct(normals.data(), 8, 8, 16, up.data());
    const std::size_t view = packed_view(
        file, packed_rows(normals, 8), 8, 8, {{"mode", "ATTRIBUTES"}, {"filter", "OCTAHEDRAL"}});
    file.json["bufferViews"][view]["byteStride"] = 8;
    file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        file.put("accessors",
                 {{"bufferView", view},
                  {"componentType", 5122},
                  {"normalized", true},
                  {"count", 8},
                  {"type", "VEC3"}});
    file.json["buffers"][0]["byteLength"] = file.data.size();
    const scene::Scene scene = import_scene(write("cube.glb", file.bytes()));
    expect_cube(scene);
    ASSERT_EQ(scene.meshes[0].normals.size(), 8U);
    EXPECT_LT(glm::length(scene.meshes[0].normals[5] - glm::vec3(0, 1, 0)), 1e-3);
}

TEST_F(GltfPacked, MeshoptStreamsThatAreNoneAreDamagedOthersRefused) {
    const Packed rows = packed_rows(cube_corners<float>(), 8);
    const auto complain = [&](const Packed& packed, const Json& how) {
        return complaint(write("bad.glb", meshopt_cube(packed, how, false).bytes()));
    };
    const Json attributes = {{"mode", "ATTRIBUTES"}};
    EXPECT_THAT(complain({rows.begin(), rows.end() - 9}, attributes),
                HasSubstr("is damaged; bufferView 1, EXT_meshopt_compression: its stream cannot be "
                          "unpacked"));
    Packed newer = rows;
    newer[0] = 0xaf;
    EXPECT_THAT(complain(newer, attributes),
                testing::StartsWith("bufferView 1, EXT_meshopt_compression: this kind of stream"));
    EXPECT_THAT(complain(rows, {{"mode", "ATTRIBUTES"}, {"count", 1 << 30}}),
                HasSubstr("count is 1073741824"));
    EXPECT_THAT(complain(rows, {{"mode", "ATTRIBUTES"}, {"byteStride", 13}}),
                HasSubstr("byteStride is 13"));
    EXPECT_THAT(complain(rows, {{"mode", "ATTRIBUTES"}, {"filter", "COLOR"}}),
                testing::StartsWith("bufferView 1, EXT_meshopt_compression: the filter COLOR"));
}

TEST_F(GltfPacked, DracoStreams) {
    for (const int speed : {0, 10})  // edgebreaker; sequential
        expect_cube(import_scene(write("draco.glb", draco_cube(speed).bytes())));
}

TEST_F(GltfPacked, DracoStreamsThatAreNoneAreDamaged) {
    GlbFile file = draco_cube(0);
    Json& extension = file.json["meshes"][0]["primitives"][0]["extensions"];
    extension["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 7;
    EXPECT_THAT(complaint(write("bad.glb", file.bytes())), HasSubstr("has no attribute 7"));
    extension["KHR_draco_mesh_compression"]["attributes"] = Json::object();
    EXPECT_THAT(complaint(write("bad.glb", file.bytes())), HasSubstr("its stream has no POSITION"));
    file = draco_cube(0);
    file.data[0] = 'X';
    EXPECT_THAT(complaint(write("bad.glb", file.bytes())),
                HasSubstr("mesh 0, primitive 0, KHR_draco_mesh_compression: its stream"));
}

}  // namespace
}  // namespace ink::import
