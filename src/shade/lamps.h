#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace ink::shade {

/// How much of a lamp's light arrives at distance `distance`: 1 up to its inner range, then falling
/// evenly to 0 at its range, where it ends with a bend that can be seen; 1 everywhere for range 0.
/// Never negative.
///
/// As engines of 1998 had it; real light falls with the square and never ends.
[[nodiscard]] double reach(const scene::OmniLight& lamp, double distance);

/// The light that arrives at a point of a surface: `ambient` plus what each lamp sends, times the
/// cosine between its direction and the unit normal; a lamp behind the surface sends nothing.
/// Lambert's law.
[[nodiscard]] glm::vec3 light_at(const glm::dvec3& p_world,
                                 const glm::dvec3& n_world,
                                 std::span<const scene::OmniLight> lamps,
                                 const glm::vec3& ambient);

/// Three lamps for a scene that has none, hung about `camera`: a bright one over its left shoulder
/// that reaches everywhere, a bluish one from the right and a reddish one from below that end
/// inside `bounds`.
[[nodiscard]] std::vector<scene::OmniLight> studio_lamps(const scene::Camera& camera,
                                                         const scene::Sphere& bounds);

}  // namespace ink::shade
