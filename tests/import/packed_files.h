#pragma once

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <vector>

#include "tests/import/glb_files.h"

// Cubes that meshoptimizer and Draco have packed.

namespace ink::import {

using Packed = std::vector<unsigned char>;

/// A view of a packed stream, in front of a buffer that is not there.
inline std::size_t packed_view(
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

inline Packed packed_indices(bool is_sequence) {
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
inline GlbFile meshopt_cube(const Packed& positions, const Json& how, bool is_sequence) {
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

/// A cube, packed by Draco by one of its two ways.
inline GlbFile draco_cube(int speed) {
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

}  // namespace ink::import
