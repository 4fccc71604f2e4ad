#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "core/error.h"
#include "entrants/entrant.h"
#include "experiment/experiment.h"
#include "harness/cells/cell.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "score/doubts.h"

namespace ink::cli {
namespace {

constexpr int kFaulty = 1;
constexpr const char* kTestScenes[] = {"cube", "torus", "blocks"};

struct EntrantTestArgs {
    std::string program;
    ExperimentOptions options;
};

/// Draws a view and prints a line about it; false if something is wrong.
bool test_view(const method::MethodConfig& config, const harness::SceneViews& scene_views) {
    const std::string place = scene_views.scene.name + " " + scene_views.views.front().camera.name;
    const auto methods = harness::prepare_methods(std::span(&config, 1), scene_views.scene);
    std::vector<edge::EdgeImage> images;
    const auto times = harness::draw_in_turns(methods, scene_views.views.front(), {}, images);
    if (!times.front().failure.empty()) {
        fmt::print("{}: {}\n", place, times.front().failure);
        return false;
    }
    truth::SceneModel model(scene_views.scene, {});
    const harness::ViewTruth truth = harness::trace_view(model, scene_views.views.front(), {});
    const score::ScoreOptions options = harness::score_options(method::threshold_of(config));
    const double f = score::score(images.front(), truth.scoring, options).f();
    const std::string doubt = score::doubt_of(images.front(), truth.scoring, options, f);
    harness::Row row;
    harness::fill_times(times.front(), row);
    fmt::print("{}: F {:.3f}, {:.1f} ms {}{}{}\n",
               place,
               f,
               1e-6 * static_cast<double>(row.draw_ns.value_or(0)),
               row.clock == harness::kOwnClock ? "by its own clock" : "of processor time in all",
               doubt.empty() ? "" : "; ",
               doubt);
    std::fflush(stdout);
    return doubt.empty();
}

void run_entrant_test(const EntrantTestArgs& args) {
    const entrants::Entrant entrant = entrants::parse_entrant("entrant=" + args.program);
    if (!entrant.is_program)
        throw core::Error("entrant-test", args.program + " is a folder", "a program");
    const experiment::Experiment asked = args.options.read();
    const method::MethodConfig config = entrants::entrant_config(entrant, asked.compare.entrant_s);
    bool is_good = true;
    for (const char* scene : kTestScenes)
        is_good = test_view(config, harness::load_one_view(scene, "", views_of(asked))) && is_good;
    if (!is_good) throw CLI::RuntimeError(kFaulty);
    fmt::print("{} is ready: inkbench compare --entrant NAME={}\n", args.program, args.program);
}

}  // namespace

void add_entrant_test_command(CLI::App& app) {
    auto args = std::make_shared<EntrantTestArgs>();
    auto* command = app.add_subcommand(
        "entrant-test", "Try a program from outside on three small scenes and say what is wrong");
    args->options.usual().sizes = {{320, 180}};
    CommandRows(*command)
        .text("program", args->program, "PROGRAM", "Called as PROGRAM view.json out.png")
        ->required();
    args->options.add_to(*command, {"grid.sizes"}, "Size of the images");
    args->options.add_to(*command, {"measure.entrant_seconds"}, "Longest time for one view");
    command->footer(
        "Example: inkbench entrant-test ./my_lines.py\n"
        "Exit codes: 0 done, the program is ready; 1 something is wrong; 2 bad input.");
    command->callback([args] { run_entrant_test(*args); });
}

}  // namespace ink::cli
