#pragma once

#include <string>
#include <vector>

#include "harness/suite/suite.h"
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

/// Something that a method may leave out, or may not.
struct Optimisation {
    std::string what;  ///< a channel, or a skip as raster::skip_infos() calls it
    bool may = false;
    std::string why;
};

/// One method on one scene.
struct MethodExplanation {
    std::string method;
    /// Depth, nx, ny, nz: of no use where the code has no weight for it, or the scene nothing to
    /// tell by it. Empty where no linear code is declared. Leaving out a weighted one changes the
    /// image.
    std::vector<Optimisation> channels;
    std::vector<Optimisation> skips;  ///< these never change a bit
    std::vector<method::PlanLine> plan;
};

/// What a scene has, and what each method may leave out there.
struct Explanation {
    std::string scene;
    std::vector<Fact> facts;
    std::vector<ViewFacts> views;
    std::vector<MethodExplanation> methods;
};

/// Prepares every configuration on the scene and asks its declared code; draws nothing.
/// `crease_deg` is the scene statistics's; a method plans with its own parameter.
[[nodiscard]] Explanation explain(const harness::SceneViews& scene_views,
                                  const std::vector<method::MethodConfig>& configs,
                                  double crease_deg);

/// For a terminal: all of it, or what fits on one, facts that are not 0 and a few lines a method.
[[nodiscard]] std::string as_text(const Explanation& explanation, bool is_whole);

}  // namespace ink::inspect
