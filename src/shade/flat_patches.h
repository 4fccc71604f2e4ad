#pragma once

#include "scene/scene.h"
#include "scene/surface.h"
#include "shade/tones.h"

namespace ink::shade {

/// Faces that bend by less than this at an edge (rad) are in one plane: float corners say no more.
inline constexpr double kFlat_rad = 1e-3;

/// One spot per triangle: its centroid and normal (+z where it has no area).
[[nodiscard]] UniformSpots face_spots(const scene::Surface& surface);

/// One spot per flat patch: faces of one plane that hang together over edges, none of which goes on
/// smoothly beyond (bends by less than `crease_rad`). The caps of a cylinder are flat patches, its
/// side is none.
///
/// The spot is the patch's centroid under its mean normal, both weighted by area. Edges of more
/// than two faces and between faces of opposite orientation end a patch like a crease. Triangles
/// that the weld drops (degenerate, duplicate) have none. An empty scene has no patches.
///
/// CoRgi's own suggestion against the gradients that shading by vertices lays over flat faces.
[[nodiscard]] UniformSpots patch_spots(const scene::Scene& scene, double crease_rad);

}  // namespace ink::shade
