#pragma once

#include <string>
#include <vector>

#include "draw/error_image.h"
#include "harness/evaluations.h"
#include "harness/method_configs.h"
#include "harness/suite.h"
#include "harness/tracing.h"
#include "method/method.h"

namespace ink::report {

/// One method's picture of a view with all that figures show of it.
struct FigureEvaluation {
    harness::Row row;
    draw::Marks marks;                  ///< empty if it failed
    std::vector<method::Layer> layers;  ///< what the method has inside
};

/// One view of a scene, drawn by all methods.
struct FigureView {
    std::string scene;
    std::string view;
    harness::ViewTruth truth;
    std::vector<FigureEvaluation> evaluations;  ///< of methods that did not fail, in their order
};

/// How scenes are drawn for figures.
struct FigureDrawing {
    std::vector<harness::MethodConfig> configs;
    harness::MeasureOptions measure;
    harness::TraceOptions trace;
    std::uint64_t seed = 0;
};

/// What came of drawing them.
struct DrawnScenes {
    std::vector<FigureView> shown;   ///< the first view of each scene
    std::vector<harness::Row> rows;  ///< of all views, baselines included
    bool is_interrupted = false;     ///< Ctrl-C: what was finished is there
};

/// Draws, traces, times and scores every view of `scenes` as `inkbench compare` does, without its
/// sweeps and cross-check; says on stderr how far it is. A view whose truth would be too large is
/// not shown, and its rows say so.
[[nodiscard]] DrawnScenes draw_scenes(const std::vector<harness::SceneViews>& scenes,
                                      const FigureDrawing& drawing);

}  // namespace ink::report
