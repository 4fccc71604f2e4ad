#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "lab/picture.h"
#include "lab/tracing.h"

namespace ink::cli {
namespace {

struct TruthArgs {
    std::string scene;
    std::string view;
    ViewOptions views;
    std::optional<std::string> file;
    std::optional<std::string> picture;
    std::optional<std::string> sampled;
    CacheOptions cache;
    double crease_deg = 40;
    int threads = core::hardware_threads();
};

void run_truth(const TruthArgs& args) {
    lab::TraceOptions options;
    options.truth.crease_rad = checked_crease_rad(args.crease_deg);
    options.truth.threads = checked_threads(args.threads);
    options.cache = cache_folder(args.cache);
    for (const auto& file : {args.file, args.picture, args.sampled}) {
        if (file) check_png_path(*file);
    }
    const lab::Subject subject =
        lab::load_one_view(args.scene, args.view, view_request(args.views));
    truth::SceneModel model(subject.scene, options.truth);
    const lab::ViewTruth truth = lab::trace_view(model, subject.views.front(), options.cache);
    if (args.file) lab::write_truth_labels(truth.traced, *args.file);
    if (args.picture) lab::write_truth_picture(truth.traced, *args.picture);
    if (args.sampled) lab::write_strengths(truth.traced.sampled, *args.sampled);
    fmt::print("{} {}\n{}",
               subject.scene.name,
               subject.views.front().camera.name,
               lab::truth_summary(truth.traced));
}

}  // namespace

void add_truth_command(CLI::App& app) {
    auto args = std::make_shared<TruthArgs>();
    auto* command = app.add_subcommand("truth", "Trace the exact outline of one view");
    command->add_option("scene", args->scene, "A built-in scene or a model file")->required();
    command->add_option("-o,--output",
                        args->file,
                        "PNG of class numbers (1 contour, 2 boundary, 3 crease, 4 intersection, "
                        "5 seam, 7 ignore)");
    command->add_option("--picture", args->picture, "PNG with a colour per class");
    command->add_option("--sampled", args->sampled, "PNG of the same lines seen at pixel centres");
    command->add_option("--view", args->view, "Name of the view (the first unless given)");
    add_view_options(*command, args->views);
    command->add_option("--crease", args->crease_deg, "Crease angle, degrees")
        ->capture_default_str();
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    add_cache_options(*command, args->cache);
    command->footer(
        "Example: inkbench truth staircase -o truth.png --picture lines.png\n"
        "Score against it with --ignore 7: inkbench score drawn.png truth.png --ignore 7 --band 6");
    command->callback([args] { run_truth(*args); });
}

}  // namespace ink::cli
