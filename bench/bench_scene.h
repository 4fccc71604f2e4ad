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

/// The meshes that everything is timed on: `sphere` (made here, 69 thousand triangles), and where
/// the files are in inkbench-out/models `dragon_coarse` (47 thousand) and `dragon` (871 thousand).
[[nodiscard]] std::vector<std::string> mesh_names();

/// The mesh called `name` as a scene of one instance; made at its first use and kept.
[[nodiscard]] const scene::Scene& bench_scene(const std::string& name);

/// The same as methods lay it out by default: shared corners, normals over patches at 40 degrees.
/// Made at its first use and kept.
[[nodiscard]] const scene::Surface& bench_surface(const std::string& name);

/// Two views a degree apart that the mesh fills from top to bottom. Benchmarks draw them in turns,
/// so that nothing is free because the last frame was the same.
[[nodiscard]] std::array<scene::View, 2> bench_views(const scene::Scene& scene);

}  // namespace ink::bench
