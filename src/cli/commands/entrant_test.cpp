#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/commands/commands.h"
#include "core/error.h"
#include "entrants/entrant.h"
#include "experiment/experiment.h"
#include "harness/cell.h"
#include "harness/suite.h"
#include "harness/tracing.h"

namespace ink::cli {
namespace {

constexpr int kFaulty = 1;
constexpr const char* kTestScenes[] = {"cube", "torus", "blocks"};

struct EntrantTestArgs {
    std::string program;
    std::string size = "320x180";
    double seconds = 60;
};

edge::EdgeImage flipped(const edge::EdgeImage& image, bool in_x, bool in_y) {
    edge::EdgeImage result(image.width_px(), image.height_px());
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            result.at(x, y) =
                image.at(in_x ? image.width_px() - 1 - x : x, in_y ? image.height_px() - 1 - y : y);
        }
    }
    return result;
}

/// What is wrong with an image that came, in a sentence; "" if nothing is.
std::string doubt_of(const edge::EdgeImage& image,
                     const score::ScoringTruth& truth,
                     int threshold,
                     double f) {
    const auto* end = image.data() + image.size();
    const auto drawn = std::count_if(image.data(), end, [&](int v) { return v >= threshold; });
    if (drawn == 0) return "no pixel counts as drawn";
    if (2 * static_cast<std::size_t>(drawn) > image.size())
        return "more than half of the image counts as drawn";
    constexpr double kBetter = 0.2;
    const score::ScoreOptions options = harness::score_options(threshold);
    const auto f_of = [&](bool in_x, bool in_y) {
        return score::score(flipped(image, in_x, in_y), truth, options).f();
    };
    if (f_of(false, true) > f + kBetter) return "it seems to be upside down";
    if (f_of(true, false) > f + kBetter) return "it seems to be mirrored";
    if (f_of(true, true) > f + kBetter) return "it seems to be turned by 180 degrees";
    if (f < 0.1) return "its lines are nowhere near the true ones: is the camera right?";
    return "";
}

/// Draws a view and prints a line about it; false if something is wrong.
bool test_view(const method::MethodConfig& config, const harness::SceneViews& scene_views) {
    const std::string place = scene_views.scene.name + " " + scene_views.views.front().camera.name;
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
    methods.push_back(std::make_unique<harness::PreparedMethod>(config, scene_views.scene));
    std::vector<edge::EdgeImage> images;
    const auto times = harness::draw_in_turns(methods, scene_views.views.front(), {}, images);
    if (!times.front().failure.empty()) {
        fmt::print("{}: {}\n", place, times.front().failure);
        return false;
    }
    truth::SceneModel model(scene_views.scene, {});
    const harness::ViewTruth truth = harness::trace_view(model, scene_views.views.front(), {});
    const int threshold = method::threshold_of(config);
    const double f =
        score::score(images.front(), truth.scoring, harness::score_options(threshold)).f();
    const std::string doubt = doubt_of(images.front(), truth.scoring, threshold, f);
    const double ms =
        times.front().draw_ns.empty() ? 0 : static_cast<double>(times.front().draw_ns[0]) * 1e-6;
    fmt::print("{}: F {:.3f}, {:.1f} ms by its own clock{}{}\n",
               place,
               f,
               ms,
               doubt.empty() ? "" : "; ",
               doubt);
    std::fflush(stdout);
    return doubt.empty();
}

void run_entrant_test(const EntrantTestArgs& args) {
    const entrants::Entrant entrant = entrants::parse_entrant("entrant=" + args.program);
    if (!entrant.is_program)
        throw core::Error("inkbench entrant-test", args.program + " is a folder", "a program");
    const method::MethodConfig config = entrants::entrant_config(entrant, {.wall_s = args.seconds});
    harness::ViewRequest request;
    const experiment::ImageSize size = experiment::parse_image_size(args.size, "--size");
    request.width_px = size.width_px;
    request.height_px = size.height_px;
    bool is_good = true;
    for (const char* scene : kTestScenes)
        is_good = test_view(config, harness::load_one_view(scene, "", request)) && is_good;
    if (!is_good) throw CLI::RuntimeError(kFaulty);
    fmt::print("{} is ready: inkbench compare --entrant NAME={}\n", args.program, args.program);
}

}  // namespace

void add_entrant_test_command(CLI::App& app) {
    auto args = std::make_shared<EntrantTestArgs>();
    auto* command = app.add_subcommand(
        "entrant-test", "Try a program from outside on three small scenes and say what is wrong");
    command->add_option("program", args->program, "Called as PROGRAM view.json out.png")
        ->type_name("PROGRAM")
        ->required();
    command->add_option("--size", args->size, "Size of the images")->capture_default_str();
    command->add_option("--entrant-seconds", args->seconds, "Longest time for one view")
        ->check(CLI::Range(0.01, 86400.0))
        ->capture_default_str();
    command->footer(
        "Example: inkbench entrant-test ./my_lines.py\n"
        "Exit codes: 0 done, the program is ready; 1 something is wrong; 2 bad input.");
    command->callback([args] { run_entrant_test(*args); });
}

}  // namespace ink::cli
