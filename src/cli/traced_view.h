#pragma once

#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"

namespace ink::cli {

/// One view with its truth, as `truth` and `score --model` trace it.
struct TracedView {
    /// Traces the first view; says on stderr how far it is and what of the model's file does not
    /// count. A view that is too large to trace is told in one line, exit code 1.
    TracedView(harness::SceneViews traced, const harness::TraceOptions& options);
    TracedView(const TracedView&) = delete;  // the model refers to the scene
    TracedView& operator=(const TracedView&) = delete;

    [[nodiscard]] const scene::View& view() const { return scene_views.views.front(); }

    harness::SceneViews scene_views;
    truth::SceneModel model;
    harness::ViewTruth truth;
};

/// Ends the program with exit code 1 and one line on stderr.
[[noreturn]] void end_too_large(const std::string& scene_name, const truth::TooLarge& reason);

}  // namespace ink::cli
