#include "import/meshes/mesh_reply.h"

#include <utility>

namespace ink::import {

ImportReply reply_of_mesh(ImportedMesh mesh, const Polygons& faces) {
    ImportReply reply;
    mesh.triangles = triangles_of(faces, mesh.positions);
    reply.instances.push_back({.mesh = 0, .name = mesh.name});
    reply.meshes.push_back(std::move(mesh));
    const std::size_t poor = count_without_area(faces);
    if (poor > 0)
        reply.notes.push_back(counted(poor, "face") + " of less than 3 corners: left out");
    return reply;
}

std::string drawn_opaque(std::size_t materials) {
    return counted(materials, "transparent material") + (materials == 1 ? " is" : " are") +
           " drawn opaque";
}

std::string counted(std::size_t count, std::string_view what) {
    return std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace ink::import
