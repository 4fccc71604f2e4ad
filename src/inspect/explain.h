#pragma once

#include <string>
#include <vector>

#include "harness/suite/suite.h"
#include "method/method.h"
#include "method/method_config.h"

namespace ink::inspect {

/// One line of the scene statistics.
struct Fact {
    std::string name;  ///< = key in JSON
    double value = 0;
    std::string unit;
    std::string doc;
    bool is_flag = false;  ///< the value is 0 or 1 and means no or yes
};

/// A view's name and its scene statistics.
struct ViewFacts {
    std::string view;
    std::vector<Fact> facts;
};

/// What a scene has, and what a method that chooses by it chose.
struct Explanation {
    std::string scene;
    std::vector<Fact> facts;
    std::vector<ViewFacts> views = {};
    std::string method = {};
    std::vector<method::PlanLine> plan = {};
};

/// Prepares the configuration of `auto` on the scene; draws nothing. `crease_deg` is the scene
/// statistics's; the method plans with its own parameter.
[[nodiscard]] Explanation explain(const harness::SceneViews& scene_views,
                                  const method::MethodConfig& config,
                                  double crease_deg);

/// For a terminal: all of it, or what fits on one: facts of the scene that are not 0, and the plan.
[[nodiscard]] std::string as_text(const Explanation& explanation, bool is_whole);

}  // namespace ink::inspect
