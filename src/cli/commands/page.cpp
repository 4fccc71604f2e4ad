#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/place.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "draw/outline_svg.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "experiment/run_data.h"
#include "harness/truths/tracing.h"
#include "report/live_page.h"

namespace ink::cli {
namespace {

struct PageArgs {
    SceneOptions scene;
    ExperimentOptions options;
    std::string run;
    std::string file;
    bool no_truth = false;
    CacheOptions cache;
};

/// The exact lines of each view; of one that is too large none, which is said.
std::vector<report::ViewLines> traced_lines(const harness::SceneViews& scene_views,
                                            harness::TraceOptions options) {
    harness::report_progress(options.truth);
    truth::SceneModel model(scene_views.scene, options.truth);
    std::vector<report::ViewLines> lines;
    for (const scene::View& view : scene_views.views) {
        lines.emplace_back();
        try {
            lines.back() = draw::class_paths(harness::trace_view(model, view, options).traced);
        } catch (const truth::TooLarge& reason) {
            fmt::print(stderr,
                       "inkbench: {} {}: no exact lines: {}\n",
                       scene_views.scene.name,
                       view.camera.name,
                       reason.what());
        }
    }
    return lines;
}

void run_page(PageArgs args) {
    if (args.file.empty() && args.run.empty())
        throw core::Error("page", "there is no file to write", "-o FILE, or --run DIR");
    if (!args.file.empty()) check_output_path(args.file, {".html"});
    const std::string name = one_scene(args.scene, "page");
    std::optional<experiment::RunData> run;
    if (!args.run.empty()) run = experiment::read_run(args.run);
    const experiment::Experiment asked = args.options.read();
    const harness::SceneViews scene_views = harness::load_scenes({name}, views_of(asked)).front();
    print_notes(scene_views);
    if (args.file.empty()) {
        const std::filesystem::path file =
            args.run / report::live_page_path(scene_views.scene.name);
        std::filesystem::create_directories(file.parent_path());
        args.file = file.string();
    }
    std::vector<report::ViewLines> lines;
    if (!args.no_truth)
        lines = traced_lines(scene_views, experiment::trace_of(asked, cache_folder(args.cache)));
    const std::string page = report::live_page(scene_views, run, lines);
    core::write_whole_file(args.file, page);
    fmt::print("{}: {:.1f} MB\n", args.file, static_cast<double>(page.size()) / 1e6);
}

}  // namespace

void add_page_command(CLI::App& app) {
    auto args = std::make_shared<PageArgs>();
    auto* command = app.add_subcommand(
        "page", "Make a page that draws a model with methods on the reader's own GPU");
    add_one_scene_options(*command, args->scene);
    CommandRows rows(*command);
    rows.text("-o,--output",
              args->file,
              "FILE",
              "HTML file to write (default, with --run: live/SCENE.html in the run's folder, to "
              "which its report then links)");
    args->options.add_to(*command, experiment::view_rows());
    rows.text("--run",
              args->run,
              "DIR",
              "Folder of a run: the page shows what its methods scored at these views");
    rows.flag("--no-truth", args->no_truth, "Trace no exact lines to lay over the picture");
    add_cache_options(*command, args->cache);
    command->footer(
        "The page is one file and opens without a network, in any browser with WebGL 2. It has "
        "the\n"
        "model with the codes of the methods in it, and their shaders to copy.\n"
        "Example: inkbench page torus -o try.html\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { run_page(*args); });
}

}  // namespace ink::cli
