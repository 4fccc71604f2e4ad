#pragma once

#include <string>
#include <vector>

#include "method/method.h"
#include "scene/scene_statistics.h"

namespace ink::methods {

/// Which method draws a scene, and what was decided on the way.
struct ScenePlan {
    std::string method;                   ///< as the registry calls it
    std::vector<method::PlanLine> lines;  ///< the choice first
};

/// The method of the highest F that is worth its time, for a scene with these statistics, and costs
/// `price` times `ids` at most. Prices are predicted from the statistics: no clock is asked.
[[nodiscard]] ScenePlan plan_scene(const scene::SceneStatistics& statistics, double price);

}  // namespace ink::methods
