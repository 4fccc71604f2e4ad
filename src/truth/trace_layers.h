#pragma once

#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/truth.h"

namespace ink::truth {

/// Layers, and the same triangles by their index in the welded topology.
struct TracedLayers {
    Layers layers;
    core::Image<std::uint32_t> face;  ///< kNoFace where there is sky
};

/// What is seen at pixel centres, one ray each, sixteen at a time; faces in front of the near plane
/// are not there. Of faces that coincide the lowest is seen, exactly: which of them a ray in float
/// meets first is chance.
[[nodiscard]] TracedLayers trace_layers(const EyeView& eye, const EyeScene& scene, int threads);

}  // namespace ink::truth
