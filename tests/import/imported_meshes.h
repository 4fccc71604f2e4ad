#pragma once

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

}  // namespace ink::import
