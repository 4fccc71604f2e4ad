#pragma once

#include <cstddef>
#include <vector>

#include "import/imported_scene.h"
#include "scene/mesh.h"
#include "tests/scene/small_meshes.h"

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

/// A cube about zero, placed once.
inline ImportReply cube_reply() {
    ImportReply reply;
    reply.meshes = {imported(scene::unit_cube())};
    reply.instances = {{0, glm::dmat4(1), "only"}};
    return reply;
}

/// What is made of a reply for a file called cube.obj.
inline scene::Scene scene_from(ImportReply reply, bool material_seams = false) {
    return scene_from_reply(std::move(reply), "dir/cube.obj", 1000, material_seams);
}

/// A node that goes from one place to another in so many seconds and does not turn.
inline scene::AnimatedNode mover(const glm::dvec3& from, const glm::dvec3& to, double seconds) {
    scene::AnimatedNode node;
    node.translations = {{0, from}, {seconds, to}};
    node.rotations = {{0, {1, 0, 0, 0}}};
    node.scales = {{0, glm::dvec3(1)}};
    node.parent_from_node[3] = glm::dvec4(from, 1);
    return node;
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
