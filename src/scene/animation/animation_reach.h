#pragma once

#include <vector>

#include "scene/animation.h"

namespace ink::scene {

/// How far a transform can carry what lies within `radius` of its origin: moved + grows * radius.
struct Reach {
    double moved = 0;
    double grows = 1;
    [[nodiscard]] double of(double radius) const { return moved + grows * radius; }
};

/// How far each node can carry what hangs on it, at rest and at any time. Nodes that only turn or
/// move grow nothing, however many there are one below the other.
[[nodiscard]] std::vector<Reach> reaches(const Animation& animation);

/// A distance from the world's zero that nothing passes which the animation moves; infinite where
/// none is found. The animation's parts must fit each other and the scene (check_animation).
[[nodiscard]] double farthest_reach(const Scene& scene, const Animation& animation);

}  // namespace ink::scene
