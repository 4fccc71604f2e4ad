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

/// How far left of its corner and above it a corner is looked at. Edges that run exactly through
/// corners are common, as the middle of an image is one: a hair beside them, no ray and no walk has
/// to tell on which side it is. A line through a corner lies right of the sample then and below, in
/// the pixel that the truth marks; and 1e-3 px, within which a face counts as met, is less.
inline constexpr double kCornerShift_px = 1.0 / 512;

/// The faces seen at pixel corners (less kCornerShift_px), by the same rules: one row and one
/// column more than the image, (x, y) the upper left corner of pixel (x, y), kNoFace where there is
/// sky.
[[nodiscard]] core::Image<std::uint32_t> trace_corners(const EyeView& eye,
                                                       const EyeScene& scene,
                                                       int threads);

}  // namespace ink::truth
