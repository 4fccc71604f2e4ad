#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/experiment_options.h"
#include "cli/options/method_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"
#include "core/split_list.h"
#include "studies/hardest/hardest_view.h"

namespace ink::cli {
namespace {

constexpr const char* kNeedsHardest = "--hardest METHOD beside it";

const std::vector<std::string> kOfAxes = {
    "grid.axes", "grid.points", "grid.projection", "grid.antialias"};
const std::vector<std::string> kOfHardest = {"search.against",
                                             "search.evaluations",
                                             "search.least_truth_px",
                                             "search.worst",
                                             "measure.crosscheck"};

/// Throws core::Error for an option of `rows` that was given.
void refuse(const ExperimentOptions& options,
            const std::vector<std::string>& rows,
            const std::string& why,
            const std::string& accepted) {
    for (const std::string& row : rows) {
        if (options.is_given(row)) throw core::Error(flag_of(row), why, accepted);
    }
}

/// Axes of difficulty, or the hardest views of scenes.
experiment::Experiment asked(const MeasureArgs& args) {
    const experiment::HardestRequest hardest = args.options.read().hardest;
    if (hardest.methods.empty()) {
        refuse(args.options, kOfHardest, "it is no option of axes", kNeedsHardest);
        if (!args.scenes.is_empty())
            throw core::Error("--scenes", "axes have scenes of their own", kNeedsHardest);
        return args.read();
    }
    refuse(args.options, kOfAxes, "it is no option of --hardest", "axes without --hardest");
    if (args.scenes.is_empty())
        throw core::Error("--scenes", "no scene is searched", "a scene or a model file");
    MeasureArgs whole = args;
    whole.options.usual().kind = experiment::ExperimentKind::hardest;
    whole.options.usual().name = "hardest";
    whole.options.usual().times = false;
    std::vector<std::string> searched = hardest.methods;
    if (!hardest.against.empty()) searched.push_back(hardest.against);
    for (const std::string& name : searched) {
        const std::vector<std::string> drawn = core::split_list(method_list(whole.methods));
        if (std::find(drawn.begin(), drawn.end(), name) == drawn.end())
            whole.methods.push_back(name);
    }
    return whole.read();
}

/// What a view must be to be found.
std::string bounds_text() {
    return fmt::format(
        "Views for --hardest: the eye {:g} to {:g} radii from the middle of the scene's box, so "
        "outside every solid; the target within the box; {:g} to {:g} degrees of view, and at most "
        "{:g} times the angle that the ball round the box takes; up is 0,1,0; an animated scene at "
        "one of {} moments. Views without a score, empty or too crowded, are none.\n",
        studies::kNearest_radii,
        studies::kFarthest_radii,
        studies::kLeastFov_deg,
        studies::kMostFov_deg,
        studies::kMostFovOfBall,
        studies::kMoments + 1);
}

}  // namespace

void add_stress_command(CLI::App& app) {
    auto args = std::make_shared<MeasureArgs>("stress", "");
    args->options.usual().kind = experiment::ExperimentKind::stress;
    args->options.usual().sizes = {{480, 270}};
    auto* command = app.add_subcommand(
        "stress",
        "Sweep one difficulty at a time: error curves per method; or find the view on which a "
        "method is worst");
    ExperimentOptions& options = args->options;
    options.add_to(*command, {"grid.axes"});
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    options.add_to(*command, {"grid.points", "grid.projection"});
    options.add_to(*command, {"search.methods", "search.against"});
    add_scene_options(*command, args->scenes, "Scenes or model files, for --hardest");
    options.add_to(*command, {"search.evaluations", "search.least_truth_px", "search.worst"});
    options.add_to(*command, {"grid.sizes"}, "Size of an image");
    options.add_to(*command, {"grid.threads"}, "Threads of a method");
    options.add_to(*command, {"seed"}, "Of the intervals, and of the search");
    options.add_to(*command, {"measure.intersections", "measure.crosscheck"});
    options.add_to(*command, {"grid.antialias", "measure.coverage", "measure.line_width_px"});
    add_cache_options(*command, args->cache);
    add_run_folder_options(*command, args->folder);
    command->footer(
        "Writes rows.csv, stress.csv, axes.csv, axis_summary.csv and report.html.\n"
        "Example: inkbench stress --axes grazing,origin --methods mote4,decaudin\n"
        "The hardest views, in hardest.csv, rows.csv and report.html of "
        "inkbench-out/hardest_NAME:\n"
        "  inkbench stress --hardest surface8 --against id_lookup --scenes rocket,my.glb\n" +
        bounds_text() +
        "Exit codes: 0 done; 1 a number was not finite, a code overflowed, a cell has no result or "
        "images differ that must not; 2 bad input; " +
        kUnscoredCode + "; 130 interrupted.");
    command->callback([args, command] {
        const experiment::Experiment experiment = asked(*args);
        RunFolderOptions folder = args->folder;
        if (folder.out.empty() && !args->scenes.is_empty())
            folder.out = "inkbench-out/hardest_" + name_after(experiment.scenes, "views");
        run_to_end(*command, experiment, folder, args->cache);
    });
}

}  // namespace ink::cli
