#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "harness/interrupt.h"
#include "harness/out_folder.h"
#include "linear_code/linear_bound_study.h"

namespace ink::cli {
namespace {

struct BoundArgs {
    std::vector<std::string> models;
    std::string scenes;
    std::string method = "mote4";
    std::vector<std::string> settings;
    ViewOptions views;
    TruthSettings truth;
    CacheOptions cache;
    bool is_signed = false;
    int threshold = 0;
    double gap = 0.005;
    std::int64_t boxes = 100000;
    int threads = 1;
    std::string out;
};

linear_code::BoundStudyOptions study_options(const BoundArgs& args) {
    linear_code::BoundStudyOptions options;
    const auto entrants = harness::make_entrants(args.method, args.settings);
    if (entrants.size() != 1) {
        throw core::Error("--method", fmt::format("'{}' is not one method", args.method), "mote4");
    }
    options.entrant = entrants.front();
    options.is_signed = args.is_signed;
    if (args.threshold < 0 || args.threshold > 4 * 65535) {
        throw core::Error("--least-threshold",
                          fmt::format("{} codes are not possible", args.threshold),
                          "0..262140");
    }
    options.least_threshold = args.threshold;
    if (!(args.gap >= 0 && args.gap <= 1)) {
        throw core::Error("--gap", fmt::format("{:g} is not possible", args.gap), "0..1");
    }
    if (args.boxes < 1) {
        throw core::Error("--boxes", fmt::format("{} is not possible", args.boxes), "1 or more");
    }
    options.search.gap = args.gap;
    options.search.most_boxes = args.boxes;
    options.search.threads = checked_threads(args.threads);
    apply(args.truth, options.trace.truth);
    options.trace.truth.threads = options.search.threads;
    options.trace.cache = cache_folder(args.cache);
    return options;
}

void run_bound(const BoundArgs& args) {
    const linear_code::BoundStudyOptions options = study_options(args);
    const auto subjects =
        harness::load_subjects(scene_names(args.scenes, args.models), view_request(args.views));
    const harness::InterruptGuard guard;
    const auto rows = linear_code::study_bounds(subjects, options);
    fmt::print("{}", linear_code::bound_table(rows));
    if (harness::is_interrupted()) {
        fmt::print(stderr, "inkbench: interrupted; no file is written\n");
        throw CLI::RuntimeError(kInterrupted);
    }
    if (args.out.empty()) return;
    const auto path = std::filesystem::path(args.out) / "bound.csv";
    core::write_whole_file(path, linear_code::bound_csv(rows));
    fmt::print("{}\n", path.string());
}

}  // namespace

void add_bound_command(CLI::App& app) {
    auto args = std::make_shared<BoundArgs>();
    auto* command = app.add_subcommand(
        "bound", "Bound from above what any four weights of a packed code could score");
    command->add_option("models", args->models, "Model files, or built-in scenes");
    command->add_option("--scenes", args->scenes, "Scenes a,b (the whole catalogue unless given)");
    command->add_option("--method,--methods", args->method, "A method whose code is a linear sum")
        ->capture_default_str();
    add_set_option(*command, args->settings);
    command->add_flag("--signed", args->is_signed, "Weights below 0 too");
    command
        ->add_option("--least-threshold",
                     args->threshold,
                     "Least threshold in codes (0: the least that the filter draws)")
        ->capture_default_str();
    command->add_option("--gap", args->gap, "Stop where upper and found are this close")
        ->capture_default_str();
    command->add_option("--boxes", args->boxes, "Stop after this many boxes of weights")
        ->capture_default_str();
    add_view_options(*command, args->views);
    add_truth_settings(*command, args->truth);
    add_cache_options(*command, args->cache);
    command->add_option("--threads", args->threads, "Threads")->capture_default_str();
    command->add_option("--out", args->out, "Folder for bound.csv");
    command->footer(
        "F is the method's own, F model what the bound's reckoning makes of its weights (it "
        "forgives surplus ink and lines that share it); no weights come above F upper, and some "
        "reach F found.\n"
        "Example: inkbench bound torus gem --method mote4 --size 640x360\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args] {
        if (!args->out.empty()) harness::make_out_folder(args->out);
        run_bound(*args);
    });
}

}  // namespace ink::cli
