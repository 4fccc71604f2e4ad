#include "cli/traced_view.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/place.h"

namespace ink::cli {
namespace {

truth::TruthOptions with_progress(truth::TruthOptions options) {
    harness::report_progress(options);
    return options;
}

}  // namespace

TracedView::TracedView(harness::SceneViews traced, const harness::TraceOptions& options)
    : scene_views(std::move(traced)), model(scene_views.scene, with_progress(options.truth)) {
    print_notes(scene_views);
    try {
        truth = harness::trace_view(model, view(), options);
    } catch (const truth::TooLarge& reason) {
        end_too_large(scene_views.scene.name, reason);
    }
}

void end_too_large(const std::string& scene_name, const truth::TooLarge& reason) {
    fmt::print(stderr, "inkbench: {}: too_large: {}\n", scene_name, reason.what());
    throw CLI::RuntimeError(1);
}

}  // namespace ink::cli
