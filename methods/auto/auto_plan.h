#pragma once

#include <vector>

#include "buffers/packed_buffer.h"
#include "scene/scene_statistics.h"

namespace ink::methods {

/// What a user may take out of the planner's hands; `planned` leaves it there.
struct PlanWishes {
    enum class Channels { planned, depth, all };
    enum class Bytes { planned, one, two };
    enum class Encoding { planned, inverse, log };

    Channels channels = Channels::planned;
    Bytes bytes = Bytes::planned;
    Encoding encoding = Encoding::planned;
    double step_scale = 1;  ///< times the planned step: above 1 fewer lines, below 1 more
};

/// The edge response that a step of the planned size is given, whatever the scene: the one
/// threshold at which all plans are scored.
inline constexpr int kPlannedResponse = 64;

/// A code made to measure.
struct CodePlan {
    buffers::Ranges ranges;
    raster::Store store = raster::Store::u16;
    raster::DepthEncoding encoding = raster::DepthEncoding::log;
    int scale_bits = 0;
    std::vector<method::PlanLine> lines;  ///< what was chosen and why

    [[nodiscard]] buffers::CodeLayout layout() const;
    /// `params` with what follows from the plan: encoding, scale, and a sky farther than far.
    [[nodiscard]] buffers::PackParams applied_to(buffers::PackParams params) const;
};

/// Plans the code for a scene, from its scene statistics and the wishes alone. Any statistics has a
/// plan.
[[nodiscard]] CodePlan make_plan(const scene::SceneStatistics& statistics,
                                 const PlanWishes& wishes);

}  // namespace ink::methods
