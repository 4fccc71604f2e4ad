#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::bench {

inline constexpr int kWidth_px = 1920;
inline constexpr int kHeight_px = 1080;

/// The meshes that rasterizer, frames and truth are timed on: `sphere` (made here, 69 thousand
/// triangles), and where the shared models are beside the project `bunny` (69 thousand) and
/// `bunny_x16` (the same, subdivided twice: 1.1 million).
[[nodiscard]] std::vector<std::string> mesh_names();

/// Those that truth is timed on: the same, and `dragon` (871 thousand) where the shared models are.
[[nodiscard]] std::vector<std::string> truth_mesh_names();

/// The mesh called `name` as a scene of one instance; made at its first use and kept.
[[nodiscard]] const scene::Scene& bench_scene(const std::string& name);

/// Two views a degree apart that the mesh fills from top to bottom. Benchmarks draw them in turns,
/// so that nothing is free because the last frame was the same.
[[nodiscard]] std::array<scene::View, 2> bench_views(const scene::Scene& scene);

}  // namespace ink::bench
