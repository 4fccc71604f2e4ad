#pragma once

#include <string>
#include <vector>

#include "method/method.h"
#include "method/method_config.h"
#include "scene/scene.h"

namespace ink::inspect {

/// One line of the scene statistics.
struct Fact {
    std::string name;  ///< = key in JSON
    double value = 0;
    std::string unit;
    std::string doc;
    bool is_flag = false;  ///< the value is 0 or 1 and means no or yes
};

/// What a scene has, and what a method that chooses by it chose.
struct Explanation {
    std::string scene;
    std::vector<Fact> facts;
    std::string method;
    std::vector<method::PlanLine> plan;
};

/// Prepares the configuration of `auto` on the scene; draws nothing. `crease_deg` is the scene
/// statistics's; the method plans with its own parameter.
[[nodiscard]] Explanation explain(const scene::Scene& scene,
                                  const method::MethodConfig& config,
                                  double crease_deg);

/// What fits on a terminal: facts that are not 0, and the plan.
[[nodiscard]] std::string as_text(const Explanation& explanation);

}  // namespace ink::inspect
