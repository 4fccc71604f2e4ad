#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "methods/mesh_lookup/lookup_mesh.h"
#include "raster/pass/view_transform.h"

namespace ink::methods {

/// x of what cannot be put on the screen; its y says why.
inline constexpr std::int32_t kOffScreen = INT32_MIN;
inline constexpr std::int32_t kBeforeNear = 0;
inline constexpr std::int32_t kFarOut = 1;

/// Takes points to the screen as the rasterizer does: 1/w, and the place in 1/256 px. All spans
/// have one size. Returns whether some lie before the near plane. The same on every SIMD target.
bool to_screen(std::span<const glm::dvec3> p_world,
               const raster::ViewTransform& transform,
               double near,
               std::span<double> q,
               std::span<glm::ivec2> places);

/// Which side of each face from `begin` to `end` the eye sees: 1 and -1, 0 edge-on. Exact.
void find_facing(const LookupMesh& mesh,
                 const scene::Viewpoint& viewpoint,
                 std::size_t begin,
                 std::size_t end,
                 std::span<std::int8_t> facing);

}  // namespace ink::methods
