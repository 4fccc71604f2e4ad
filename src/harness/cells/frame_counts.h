#pragma once

#include "method/cost.h"
#include "scene/scene.h"

namespace ink::harness {

/// What one view of a scene asks of a rasterizer.
struct FrameCounts {
    double vertices = 0;    ///< of the meshes, counted once per instance
    double triangles = 0;   ///< over all instances, those outside the image too
    double covered_px = 0;  ///< area in the image summed over all triangles, hidden ones too
    double frame_px = 0;    ///< width times height
};

/// Counted from the geometry in double precision, never from a method's work: triangles are cut at
/// the near plane and the image's frame, and their areas added up.
[[nodiscard]] FrameCounts count_frame(const scene::Scene& scene, const scene::View& view);

/// What the cost model knows of a row: what the method declares and what the view asks of it.
struct CostFacts {
    method::Cost declared;
    FrameCounts frame;
};

}  // namespace ink::harness
