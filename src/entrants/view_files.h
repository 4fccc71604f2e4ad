#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace ink::entrants {

/// Files of one view for a program outside.
struct ViewFiles {
    std::filesystem::path obj = {};      ///< the mesh as drawn
    std::filesystem::path glb = {};      ///< the same
    std::filesystem::path buffers = {};  ///< EXR of depth, normals and ids
    std::filesystem::path ids = {};      ///< PNG of object ids
};

/// All that a program needs to draw `view` as JSON: scene, view, size, camera (eye, target, up,
/// field of view, near and far), matrices by rows, the conventions in words, and the files' names.
[[nodiscard]] std::string view_json(const scene::Scene& scene,
                                    const scene::View& view,
                                    const ViewFiles& files);

/// Writes the meshes of a scene to `folder`: mesh.obj and mesh.glb. Makes the folder.
[[nodiscard]] ViewFiles write_meshes(const scene::Scene& scene,
                                     const std::filesystem::path& folder);

/// Writes camera.json, buffers.exr and ids.png of a view to `folder`. `meshes` says where the
/// meshes are; camera.json names all files relative to `folder`. Makes the folder. Throws
/// core::Error for what cannot be written.
void write_view(const scene::Scene& scene,
                const scene::View& view,
                const ViewFiles& meshes,
                double crease_rad,
                const std::filesystem::path& folder);

}  // namespace ink::entrants
