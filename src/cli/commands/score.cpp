#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/score_text.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "harness/images/out_folder.h"
#include "image_io/image_file.h"
#include "score/coverage.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kFTooLow = 1;
constexpr int kImagesUnscored = 3;

/// The command line of `score`.
struct ScoreArguments {
    fs::path prediction;
    fs::path truth;
    std::string model;  ///< a scene or model file instead of a truth
    std::string view;
    CacheOptions cache;
    given_images::ScoreRequest request;
    ExperimentOptions options;
    std::string picture;
    std::string csv;
    std::string markdown;
    std::optional<double> fail_under;
    bool no_thin = false;
    bool as_json = false;
};

/// Exit code 1 for an F below what was asked, or none.
void check_least_f(const ScoreArguments& a, std::optional<double> f) {
    if (!a.fail_under || (f && *f >= *a.fail_under)) return;
    const std::string what =
        f ? fmt::format("F = {:.4f} is below", *f) : "there is no F, which is to be at least";
    fmt::print(stderr, "inkbench: {} {}\n", what, *a.fail_under);
    throw CLI::RuntimeError(kFTooLow);
}

void print_doubts(const given_images::FilesScore& scored) {
    for (const std::string& doubt : scored.doubts)
        fmt::print(stderr, "inkbench: {}\n", doubt);
}

/// Traces what the image shows, in its own size, and scores it; `truth_name` becomes what was
/// traced.
given_images::FilesScore score_against_model(const ScoreArguments& a,
                                             const CLI::App& command,
                                             std::string& truth_name) {
    score::check(a.request.options);
    harness::OutlineImage image = harness::read_outline_image(a.prediction, a.request.polarity);
    const std::string own_size =
        fmt::format("{}x{}", image.responses.width_px(), image.responses.height_px());
    experiment::Experiment asked = a.options.read();
    const experiment::ImageSize size{image.responses.width_px(), image.responses.height_px()};
    for (const std::string& given : a.options.given("grid.sizes")) {
        if (given == own_size) continue;
        throw core::Error(
            "--size",
            fmt::format(
                "it is {}, but the size of {} is {}", given, a.prediction.string(), own_size),
            recorded_command(command, {"--size"}));
    }
    const TracedView traced(harness::load_one_view(a.model, a.view, views_of(asked, size)),
                            experiment::trace_of(asked, cache_folder(a.cache)));
    truth_name = fmt::format("{}, view {}", a.model, traced.view().camera.name);
    given_images::TruthLabels truth{traced.truth.counted_labels(),
                                    static_cast<int>(truth::LineClass::ignore),
                                    harness::kBand_px,
                                    true};
    if (a.request.line_width_px) {
        truth.line_width_px = *a.request.line_width_px;
        truth.coverage = score::draw_coverage(traced.truth.traced.curves,
                                              traced.view().width_px,
                                              traced.view().height_px,
                                              truth.line_width_px);
    }
    return given_images::score_outline(
        {a.prediction.string(), std::move(image)}, {truth_name, std::move(truth)}, a.request);
}

void write_tables(const ScoreArguments& a, const std::vector<given_images::FolderScore>& scores) {
    if (!a.csv.empty()) core::write_whole_file(a.csv, folder_csv(scores));
    if (!a.markdown.empty()) core::write_whole_file(a.markdown, folder_table(scores, true));
}

void score_pair(const ScoreArguments& a, const CLI::App& command) {
    if (!a.picture.empty()) check_output_path(a.picture, {".png"});
    std::string truth_name = a.truth.filename().string();
    const given_images::FilesScore scored =
        a.model.empty() ? given_images::score_files(a.prediction, a.truth, a.request)
                        : score_against_model(a, command, truth_name);
    if (!a.picture.empty()) image_io::write_png(given_images::picture_of(scored), a.picture);
    given_images::FolderScore line{a.prediction.filename().string()};
    if (scored.score.n_truth > 0) {
        line.score = scored.score;
        line.soft = scored.soft;
    } else {
        line.status = given_images::kNoTruth;
    }
    write_tables(a, {line});
    fmt::print("{}",
               a.as_json ? score_json(scored) : score_table(a.prediction, truth_name, scored));
    std::fflush(stdout);
    print_doubts(scored);
    check_least_f(a, scored.score.f_of_truth());
}

void score_all(const ScoreArguments& a) {
    const auto draw_picture = [&](const std::string& name, const given_images::FilesScore& scored) {
        print_doubts(scored);
        if (a.picture.empty()) return;
        const fs::path path = fs::path(a.picture) / (name + ".png");
        harness::make_out_folder(path.parent_path());
        image_io::write_png(given_images::picture_of(scored), path);
    };
    const auto scores = given_images::score_folders(a.prediction, a.truth, a.request, draw_picture);
    write_tables(a, scores);
    const auto unmatched = given_images::files_without_truth(a.prediction, a.truth);
    fmt::print("{}", a.as_json ? folder_json(scores, unmatched) : folder_table(scores));
    std::fflush(stdout);
    if (!unmatched.empty()) {
        fmt::print(stderr,
                   "inkbench: {} has no truth for {}\n",
                   a.truth.string(),
                   fmt::join(unmatched, ", "));
    }
    const auto is_scored = [](const given_images::FolderScore& each) { return each.is_scored(); };
    check_least_f(a, given_images::pooled_f(scores));
    if (std::all_of(scores.begin(), scores.end(), is_scored)) return;
    fmt::print(stderr, "inkbench: some images have no score\n");
    throw CLI::RuntimeError(std::any_of(scores.begin(), scores.end(), is_scored) ? kImagesUnscored
                                                                                 : kFTooLow);
}

void run_score(ScoreArguments a, const CLI::App& command) {
    a.request.options.thin = !a.no_thin;
    const experiment::Experiment asked = a.options.read();
    a.request.intersections = asked.intersections;
    a.request.line_width_px = scored_width_px(asked);
    if (!a.csv.empty()) check_output_path(a.csv, {".csv"});
    if (!a.markdown.empty()) check_output_path(a.markdown, {".md"});
    const bool is_folder = fs::is_directory(a.prediction);
    if (a.truth.empty() == a.model.empty()) {
        throw core::Error("truth",
                          a.model.empty() ? "it is missing" : "there is a --model beside it",
                          "the file of inkbench truth -o, or --model MODEL");
    }
    if (!a.model.empty()) {
        if (is_folder)
            throw core::Error("--model", a.prediction.string() + " is a folder", "one image");
        return score_pair(a, command);
    }
    if (is_folder != fs::is_directory(a.truth)) {
        throw core::Error(
            (is_folder ? a.truth : a.prediction).string(),
            "this is no folder, but " + (is_folder ? a.prediction : a.truth).string() + " is one",
            "two files, or two folders");
    }
    return is_folder ? score_all(a) : score_pair(a, command);
}

void add_scoring_options(CLI::App& command, ScoreArguments& a) {
    CommandRows rows(command);
    score::ScoreOptions& options = a.request.options;
    // clang-format off
    rows.number("--tol", options.tolerance_px, kAnyNumber, "PX",
                "Matched pixels are at most this far apart, at most 8");
    rows.number("--threshold", options.threshold, {1, 255}, "N",
                "Edge response of a predicted pixel, 1..255");
    rows.choice("--polarity", a.request.polarity, {"auto", "light", "dark"},
                "Lines are light on dark, dark on light, or auto: dark where more than three "
                "quarters of the image are light");
    rows.flag("--no-thin", a.no_thin, "Do not thin the prediction");
    rows.number("--band", a.request.band_px, {0, 16384}, "PX",
                "Leave out this many pixels along the frame (default: what the truth says, else "
                "0)");
    rows.number("--ignore", options.ignore_label, {1, 255}, "N",
                "Truth value, 1..255, that is neither required nor penalised (default: what the "
                "truth says, else none)");
    // clang-format on
    a.options.add_to(command, {"measure.intersections", "measure.coverage"});
    a.options.add_to(command,
                     {"measure.line_width_px"},
                     "Width of the true lines with --coverage; that of a truth file is 1.5");
}

/// What is traced instead of reading a truth.
void add_model_options(CLI::App& command, ScoreArguments& a) {
    CommandRows rows(command);
    CLI::Option* model =
        rows.text("--model",
                  a.model,
                  "SCENE",
                  "A model file or built-in scene, which is traced in the image's size");
    const std::size_t before = command.get_options().size();
    rows.text("--view", a.view, "NAME", "Name of the view (default: the first)");
    a.options.add_to(command, experiment::view_rows());
    a.options.add_to(command, {"measure.crease_deg", "measure.creases", "measure.weld_epsilon"});
    add_cache_options(command, a.cache);
    const auto options = command.get_options();
    for (std::size_t i = before; i < options.size(); ++i)
        options[i]->needs(model);
    command.get_option("--size")->default_str("that of the image");
    add_quiet_option(command);
}

}  // namespace

void add_score_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "score", "Score an outline image against a truth image or a model, or a folder of images");
    auto a = std::make_shared<ScoreArguments>();
    CommandRows rows(*command);
    // clang-format off
    rows.text("prediction", a->prediction, "FILE",
              "Outline image of any depth, in grey or colour, with alpha or without; or a folder "
              "of them")
        ->required();
    rows.text("truth", a->truth, "FILE",
              "What inkbench truth -o writes: the .exr, or the 8-bit image of classes (0 no line, "
              "every other value a class; if it holds nothing but 0 and 1, or 0 and 255, its lines "
              "have no class). Or a folder of them, with the names of the predictions");
    // clang-format on
    add_scoring_options(*command, *a);
    add_model_options(*command, *a);
    // clang-format off
    rows.text("--picture", a->picture, "FILE",
              "PNG of what is right, missing and false; of folders: a folder for them");
    rows.text("--csv", a->csv, "FILE", "CSV with a line per image");
    rows.text("--markdown", a->markdown, "FILE", "The same as a table of Markdown, a .md");
    rows.number("--fail-under", a->fail_under, {0, 1}, "F",
                "Exit with 1 if F (of folders: pooled) is below this");
    rows.flag("--json", a->as_json, "Print JSON instead of a table");
    // clang-format on
    command->footer(
        "Example: inkbench score pred.png truth.exr --tol 1 --json\n"
        "         inkbench score render.exr --model scene.glb --views file\n"
        "compare scores with the ignore label and band of the truth, and each method's own "
        "--threshold.\n"
        "Exit codes: 0 done, 1 F is below --fail-under or no image of a folder has a score, 2 bad "
        "input, 3 some\nimages of a folder have no score.");
    command->callback([a, command] { run_score(*a, *command); });
}

}  // namespace ink::cli
