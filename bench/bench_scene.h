#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::bench {

inline constexpr int kWidth_px = 1920;
inline constexpr int kHeight_px = 1080;

/// A size of image as names have it.
struct ImageSize {
    std::string name;
    int width_px = 0;
    int height_px = 0;
};

/// `1080p` (1920 x 1080) and `2160p` (3840 x 2160).
[[nodiscard]] std::vector<ImageSize> image_sizes();

/// The meshes that everything is timed on: `sphere` (made here, 69 thousand triangles), and where
/// the shared models are beside the project `bunny` (69 thousand), `bunny_x16` (the same,
/// subdivided twice: 1.1 million) and `dragon` (871 thousand). What add_model was given comes last.
[[nodiscard]] std::vector<std::string> mesh_names();

/// Adds a model file to the meshes, by its name without extension. Throws core::Error if there is
/// no such file.
void add_model(const std::filesystem::path& path);

/// The mesh called `name` as a scene of one instance; made at its first use and kept.
[[nodiscard]] const scene::Scene& bench_scene(const std::string& name);

/// The same as methods lay it out by default: shared corners, normals over patches at 40 degrees.
/// Made at its first use and kept.
[[nodiscard]] const scene::Surface& bench_surface(const std::string& name);

/// Two views a degree apart that the mesh fills from top to bottom. Benchmarks draw them in turns,
/// so that nothing is free because the last frame was the same.
[[nodiscard]] std::array<scene::View, 2> bench_views(const scene::Scene& scene,
                                                     const ImageSize& size = {
                                                         "1080p", kWidth_px, kHeight_px});

/// The meshes that are held against the prototype of `bench/limits.py`: the same, and `sphere_x16`
/// (made here, 1.1 million triangles), which is closed.
[[nodiscard]] std::vector<std::string> limit_mesh_names();

/// Writes them to a folder as OBJ, which the prototype reads. Throws core::Error if it cannot.
void write_limit_meshes(const std::filesystem::path& folder);

/// What the prototype sees: from (0.8, 0.55, 2.6) radii of the ball round the middle of the mesh's
/// box, which nearly fills the height of kWidth_px x kHeight_px.
[[nodiscard]] scene::View limit_view(const scene::Scene& scene);

}  // namespace ink::bench
