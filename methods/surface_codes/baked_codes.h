#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "methods/surface_codes/smooth_mesh.h"
#include "scene/prepared_scene.h"

namespace ink::methods {

struct CodeParams;
struct CodeSetup;

/// A method that draws one code a triangle, whose codes need no view.
enum class BakedMethod { surface8, label8 };

/// The codes that the method draws at its default settings but for the crease angle: 1..255, one
/// per triangle of the scene as it stands, by global index; see SurfaceCodes. An empty scene has
/// none.
[[nodiscard]] std::vector<std::uint32_t> baked_codes(const scene::PreparedScene& scene,
                                                     BakedMethod method,
                                                     double crease_deg);

/// The same of surface8, repaired until few pixels of random views are wrong: views of `scene` and
/// of eight moments of each of `motions`, which are that scene with an animation. The same on every
/// machine; takes seconds.
[[nodiscard]] std::vector<std::uint32_t> repaired_codes(const scene::PreparedScene& scene,
                                                        double crease_deg,
                                                        std::span<const scene::Scene> motions);

/// The same at any settings.
[[nodiscard]] std::vector<std::uint32_t> repaired_codes(const scene::PreparedScene& scene,
                                                        const CodeParams& params,
                                                        const CodeSetup& setup,
                                                        std::span<const scene::Scene> motions = {});

/// The welded scene, cut into smooth patches, that these codes are made from.
[[nodiscard]] std::shared_ptr<const SmoothMesh> baked_mesh(const scene::PreparedScene& scene,
                                                           double crease_deg);

}  // namespace ink::methods
