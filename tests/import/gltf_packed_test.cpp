// Meshes that meshoptimizer and Draco have packed come out as they went in.

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <meshoptimizer.h>

#include <glm/geometric.hpp>

#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::HasSubstr;
using GltfPacked = ModelFiles;

using Packed = std::vector<unsigned char>;

/// A view of a packed stream, in front of a buffer that is not there.
std::size_t packed_view(
    GlbFile& file, const Packed& packed, std::size_t count, std::size_t stride, const Json& how) {
    const std::size_t inner = file.view({packed.begin(), packed.end()});
    Json extension = {{"buffer", 0},
                      {"byteOffset", file.json["bufferViews"][inner]["byteOffset"]},
                      {"byteLength", packed.size()},
                      {"count", count},
                      {"byteStride", stride}};
    extension.update(how);
    return file.put("bufferViews",
                    {{"buffer", 1},
                     {"byteLength", count * stride},
                     {"extensions", {{"EXT_meshopt_compression", extension}}}});
}

template <class T>
Packed packed_rows(const std::vector<T>& rows, std::size_t count) {
    const std::size_t stride = rows.size() * sizeof(T) / count;
    Packed packed(meshopt_encodeVertexBufferBound(count, stride));
    packed.resize(
        meshopt_encodeVertexBuffer(packed.data(), packed.size(), rows.data(), count, stride));
    return packed;
}

Packed packed_indices(bool is_sequence) {
    const std::vector<unsigned> indices(kCubeIndices.begin(), kCubeIndices.end());
    Packed packed(is_sequence ? meshopt_encodeIndexSequenceBound(indices.size(), 8)
                              : meshopt_encodeIndexBufferBound(indices.size(), 8));
    const unsigned* from = indices.data();
    packed.resize(
        is_sequence
            ? meshopt_encodeIndexSequence(packed.data(), packed.size(), from, indices.size())
            : meshopt_encodeIndexBuffer(packed.data(), packed.size(), from, indices.size()));
    return packed;
}

/// A cube, packed; `how` says by which filter its positions are.
GlbFile meshopt_cube(const Packed& positions, const Json& how, bool is_sequence) {
    GlbFile file;
    const std::size_t rows = packed_view(file, positions, 8, 12, how);
    const std::size_t indices = packed_view(file,
                                            packed_indices(is_sequence),
                                            36,
                                            2,
                                            {{"mode", is_sequence ? "INDICES" : "TRIANGLES"}});
    file.put("accessors",
             {{"bufferView", rows}, {"componentType", 5126}, {"count", 8}, {"type", "VEC3"}});
    file.put("accessors",
             {{"bufferView", indices}, {"componentType", 5123}, {"count", 36}, {"type", "SCALAR"}});
    file.put("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}});
    file.put("nodes", {{"mesh", 0}});
    file.json["buffers"] = {{{"byteLength", file.data.size()}},
                            {{"byteLength", 8 * 12 + 36 * 2},
                             {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    file.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return file;
}

void expect_cube(const scene::Scene& scene) {
    expect_box(box_of(scene), {0, 0, 0}, {1, 1, 1});
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

/// A cube, packed by Draco by one of its two ways.
GlbFile draco_cube(int speed) {
    const std::vector<float> corners = cube_corners<float>();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(12);
    const int positions =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t t = 0; t < 12; ++t)
        builder.SetAttributeValuesForFace(positions,
                                          draco::FaceIndex(t),
                                          &corners[3 * kCubeIndices[3 * t]],
                                          &corners[3 * kCubeIndices[3 * t + 1]],
                                          &corners[3 * kCubeIndices[3 * t + 2]]);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetSpeedOptions(speed, speed);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    GlbFile file;
    const std::size_t view = file.view({buffer.data(), buffer.size()});
    file.put("accessors", {{"componentType", 5126}, {"count", 8}, {"type", "VEC3"}});
    file.put("accessors", {{"componentType", 5123}, {"count", 36}, {"type", "SCALAR"}});
    file.put(
        "meshes",
        {{"primitives",
          {{{"attributes", {{"POSITION", 0}}},
            {"indices", 1},
            {"extensions",
             {{"KHR_draco_mesh_compression",
               {{"bufferView", view},
                {"attributes", {{"POSITION", mesh->attribute(positions)->unique_id()}}}}}}}}}}});
    file.put("nodes", {{"mesh", 0}});
    file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return file;
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
