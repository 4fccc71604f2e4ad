#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "import/scene_stream.h"
#include "scene/scene.h"

namespace ink::import {

/// How far a foreign file is trusted: it is parsed in a child process that cannot do more than
/// this.
struct ImportLimits {
    /// The import executable; empty: `inkbench_import` in this program's own folder.
    std::filesystem::path child;
    double wall_s = 60;                       ///< it is killed after this long
    std::uint64_t memory_bytes = 8ULL << 30;  ///< of address space
    std::uint64_t output_bytes = 2ULL << 30;  ///< of scene data it may hand back
    /// Over all instances: a small file may place one mesh a million times.
    std::uint64_t triangles = 100'000'000;
};

/// Where the triangles of a scene stand in its file.
struct FilePlaces {
    /// Per instance the number of its node; scene::kNoNode: files of this format have none.
    std::vector<std::uint32_t> node_of_instance;
    /// Per mesh of the scene, see MeshPart; not where objects were split by material.
    std::vector<std::vector<MeshPart>> parts_of_mesh;
};

/// What `import_model` gives.
struct ImportedModel {
    scene::Scene scene;
    FilePlaces places;
    /// By material number colour and opacity, 0..1, see ImportReply; glTF's own are not read.
    std::vector<glm::vec4> base_colors;
    /// Per mesh of OBJ and PLY files, see ImportedMesh; not where objects were split by material.
    std::vector<std::vector<glm::vec2>> texcoords{};
};

/// As `import_scene`, and where in the file its triangles stand.
[[nodiscard]] ImportedModel import_model(const std::filesystem::path& path,
                                         const ModelChoice& choice = {},
                                         const ImportLimits& limits = {});

/// The scene in a model file of one of the formats that README.md lists, checked (`check_scene`,
/// `check_animation`), named by the file's stem, with the file's own cameras (near and far fitted)
/// and its node tree flattened to instances: one for each node with a mesh, and no mesh without
/// triangles. Points and lines are left out.
///
/// Vertices stay as the file has them, but for `Scene::origin`; z-up formats that say so, and
/// Quake's, are turned by the instances' transforms. A mesh keeps its normals (made unit) only if
/// every triangle with an area has good ones. Material numbers are unique within the file. Names
/// are printable; those of cameras are distinct and fit for file names. A camera that looks nowhere
/// is left out. The scene's split is `real`. It stands as the file has it at rest, or in its first
/// frame; `animation` holds what moves: stored frames, or the chosen animation's keys on nodes,
/// bones and the cameras on those nodes.
///
/// Throws Error with where = the path, in one line: no such file, not a regular file, not readable,
/// empty, not a model, of an unknown kind, shorter or poorer than its own header says, no triangle,
/// a number that is not finite, more than the limits allow, or a reader that crashed, hung or asked
/// for too much memory; with where = the import executable if that is missing. Safe to call from
/// several threads; leaves no process behind.
[[nodiscard]] scene::Scene import_scene(const std::filesystem::path& path,
                                        const ModelChoice& choice = {},
                                        const ImportLimits& limits = {});

}  // namespace ink::import
