#pragma once

#include <optional>
#include <vector>

#include "inspect/explain.h"
#include "scene/scene_statistics.h"

namespace ink::inspect {

/// What skips ask of a scene.
struct SceneFacts {
    scene::SceneStatistics statistics;
    std::vector<scene::ViewStatistics> views;
    std::size_t solids = 0;             ///< as the rasterizer cuts them: within one object each
    std::size_t watertight_solids = 0;  ///< with their holes covered, if they have a few small ones
};

/// Which channels of `code` are of no use on a scene with these statistics; empty without a code.
[[nodiscard]] std::vector<Optimisation> channel_optimisations(
    const std::optional<method::LinearCode>& code, const scene::SceneStatistics& statistics);

/// Every skip of raster::skip_infos(), in their order: whether the method may use it here.
[[nodiscard]] std::vector<Optimisation> skip_optimisations(
    const std::optional<method::LinearCode>& code, const SceneFacts& facts);

}  // namespace ink::inspect
