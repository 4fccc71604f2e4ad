#pragma once

#include <cstddef>
#include <vector>

#include "import/scene_stream.h"
#include "scene/mesh.h"

namespace ink::import {

/// The mesh as a reader hands it over.
inline ImportedMesh imported(const scene::Mesh& mesh) {
    ImportedMesh result;
    result.name = mesh.name;
    result.positions.assign(mesh.positions.begin(), mesh.positions.end());
    result.normals = mesh.normals;
    result.triangles = mesh.triangles;
    return result;
}

/// What write_reply writes.
inline std::vector<std::byte> stream_of(const ImportReply& reply) {
    std::vector<std::byte> stream;
    write_reply(reply, [&](const void* data, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(data);
        stream.insert(stream.end(), bytes, bytes + size);
    });
    return stream;
}

}  // namespace ink::import
