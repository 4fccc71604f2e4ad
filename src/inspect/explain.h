#pragma once

#include <string>
#include <vector>

#include "harness/suite/suite.h"
#include "method/method.h"
#include "method/method_config.h"
#include "raster/skips.h"

namespace ink::inspect {

/// One line of the scene statistics.
struct Fact {
    std::string name;  ///< = key in JSON
    double value = 0;
    std::string unit;
    std::string doc;
    bool is_flag = false;  ///< the value is 0 or 1 and means no or yes
};

/// What a method left undone in the first view, and what it chose for the scene.
struct MethodExplanation {
    std::string method;
    raster::SkipCounts skips{};
    std::vector<method::PlanLine> plan;  ///< empty for methods that plan nothing
};

/// What a scene has, and what methods make of it.
struct Explanation {
    std::string scene;
    std::vector<Fact> facts;
    std::vector<MethodExplanation> methods;
};

/// Prepares each method on the scene and draws the first view, if there is one. `crease_deg` is
/// the scene statistics's; methods plan with their own parameter. Throws core::Error (where = the
/// method) if one cannot prepare the scene.
[[nodiscard]] Explanation explain(const harness::SceneViews& scene_views,
                                  const std::vector<method::MethodConfig>& configs,
                                  double crease_deg);

/// What fits on a terminal: facts and counts that are not 0, and the plans.
[[nodiscard]] std::string as_text(const Explanation& explanation);

}  // namespace ink::inspect
