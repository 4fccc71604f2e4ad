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
/// the files are in inkbench-out/models `dragon_coarse` (47 thousand) and `dragon` (871 thousand).
/// What add_model was given comes last.
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

}  // namespace ink::bench
