#pragma once

#include <string>
#include <vector>

#include "lab/entrants.h"
#include "lab/error_picture.h"
#include "lab/shots.h"
#include "lab/suite.h"
#include "lab/tracing.h"
#include "methods/method.h"

namespace ink::lab {

/// One method's picture of a view with all that figures show of it.
struct FigureShot {
    Row row;
    Marks marks;                         ///< empty if it failed
    std::vector<methods::Layer> layers;  ///< what the method has inside
};

/// One view of a scene, drawn by all methods.
struct FigureView {
    std::string scene;
    std::string view;
    ViewTruth truth;
    std::vector<FigureShot> shots;  ///< of methods that did not fail, in their order
};

/// How scenes are drawn for figures.
struct FigureDrawing {
    std::vector<Entrant> entrants;
    MeasureOptions measure;
    TraceOptions trace;
    std::uint64_t seed = 0;
};

/// What came of drawing them.
struct DrawnScenes {
    std::vector<FigureView> shown;  ///< the first view of each scene
    std::vector<Row> rows;          ///< of all views, brackets included
    bool is_interrupted = false;    ///< Ctrl-C: what was finished is there
};

/// Draws, traces, times and scores every view of `subjects` as `inkbench compare` does, without its
/// sweeps and witness; says on stderr how far it is. A view whose truth would be too large is not
/// shown, and its rows say so.
[[nodiscard]] DrawnScenes draw_scenes(const std::vector<Subject>& subjects,
                                      const FigureDrawing& drawing);

}  // namespace ink::lab
