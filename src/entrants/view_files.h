#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "core/image.h"
#include "scene/scene.h"

namespace ink::entrants {

/// Writes the scene as it stands as Wavefront OBJ: world-space positions to the last digit, an `o`
/// per instance in the order of object ids, `usemtl material_N` per run of triangles of a material,
/// triangles in the order of global indices. No normals. Throws core::Error if it cannot be
/// written.
void write_obj(const scene::Scene& scene, const std::filesystem::path& path);

/// Writes the scene as it stands as binary glTF 2.0: a mesh per mesh with a primitive per material,
/// a node per instance with its matrix and `extras.object`, materials with `extras.material`.
/// Positions are the same floats; normals where the file had them. A camera per view, called by its
/// name. `base_colors` are colours and opacities by material number, 0..1; the rest are white.
/// `texcoords` are TEXCOORD_0 of each mesh as glTF has them, one per position or none. Throws
/// core::Error if it cannot be written, or needs more than the 4 GiB that the format holds.
void write_glb(const scene::Scene& scene,
               std::span<const scene::View> views,
               const std::filesystem::path& path,
               std::span<const glm::vec4> base_colors = {},
               std::span<const std::vector<glm::vec2>> texcoords = {});

/// What each pixel centre of a view sees, as engines have it in their buffers.
struct ViewBuffers {
    core::Image<std::uint32_t> triangle;  ///< global index, kNoId for the sky
    core::Image<std::uint32_t> object;    ///< instance
    core::Image<std::uint32_t> patch;     ///< smooth patch within its object
    core::Image<std::uint32_t> material;
    core::Image<float> w;                      ///< distance along the view direction, infinity
    std::array<core::Image<float>, 3> normal;  ///< view space, unit, over patches; 0 for the sky
};

/// Draws the buffers of a view: ids by the rasterizer of the methods, distance and normal from the
/// triangle that is seen. `crease_rad` parts smooth patches.
[[nodiscard]] ViewBuffers view_buffers(const scene::Scene& scene,
                                       const scene::View& view,
                                       double crease_rad);

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

/// Writes the meshes of a scene to `folder`: mesh.obj and mesh.glb, this with a camera per
/// view. Makes the folder.
[[nodiscard]] ViewFiles write_meshes(const scene::Scene& scene,
                                     std::span<const scene::View> views,
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
