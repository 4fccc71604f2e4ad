#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "cli/commands/commands.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/score_text.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "draw/image_output.h"
#include "harness/out_folder.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kFTooLow = 1;
constexpr int kImagesUnscored = 3;

/// The command line of `score`.
struct ScoreArguments {
    fs::path prediction;
    fs::path truth;
    draw::ScoreRequest request;
    std::string polarity = "auto";
    ExperimentOptions options;
    std::string picture;
    std::string csv;
    std::optional<double> fail_under;
    bool is_inverted = false;
    bool no_thin = false;
    bool as_json = false;
};

draw::Polarity asked_polarity(const ScoreArguments& a) {
    static const std::map<std::string, draw::Polarity> kPolarities = {
        {"auto", draw::Polarity::automatic},
        {"light", draw::Polarity::light_on_dark},
        {"dark", draw::Polarity::dark_on_light}};
    const auto found = kPolarities.find(a.polarity);
    if (found == kPolarities.end()) {
        throw core::Error(
            "--polarity", "there is no polarity '" + a.polarity + "'", "auto, light, dark");
    }
    return a.is_inverted ? draw::Polarity::dark_on_light : found->second;
}

/// Exit code 1 for an F below what was asked, or none.
void check_least_f(const ScoreArguments& a, std::optional<double> f) {
    if (!a.fail_under || (f && *f >= *a.fail_under)) return;
    const std::string what =
        f ? fmt::format("F = {:.4f} is below", *f) : "there is no F, which is to be at least";
    fmt::print(stderr, "inkbench: {} {}\n", what, *a.fail_under);
    throw CLI::RuntimeError(kFTooLow);
}

void print_doubts(const draw::FilesScore& scored) {
    for (const std::string& doubt : scored.doubts)
        fmt::print(stderr, "inkbench: {}\n", doubt);
}

void score_pair(const ScoreArguments& a) {
    if (!a.picture.empty()) check_output_path(a.picture, {".png"});
    const draw::FilesScore scored = draw::score_files(a.prediction, a.truth, a.request);
    if (!a.picture.empty()) draw::write_drawing(draw::picture_of(scored), a.picture);
    if (!a.csv.empty()) {
        draw::FolderScore line{a.prediction.filename().string()};
        if (scored.score.n_truth > 0) {
            line.score = scored.score;
        } else {
            line.status = draw::kNoTruth;
        }
        core::write_whole_file(a.csv, folder_csv({line}));
    }
    fmt::print("{}", a.as_json ? score_json(scored) : score_table(a.prediction, a.truth, scored));
    std::fflush(stdout);
    print_doubts(scored);
    check_least_f(a, scored.score.f_of_truth());
}

void score_all(const ScoreArguments& a) {
    const auto draw_picture = [&](const std::string& name, const draw::FilesScore& scored) {
        print_doubts(scored);
        if (a.picture.empty()) return;
        const fs::path path = fs::path(a.picture) / (name + ".png");
        harness::make_out_folder(path.parent_path());
        draw::write_drawing(draw::picture_of(scored), path);
    };
    const auto scores = draw::score_folders(a.prediction, a.truth, a.request, draw_picture);
    if (!a.csv.empty()) core::write_whole_file(a.csv, folder_csv(scores));
    fmt::print("{}", a.as_json ? folder_json(scores) : folder_table(scores));
    std::fflush(stdout);
    const auto is_scored = [](const draw::FolderScore& each) { return each.is_scored(); };
    check_least_f(a, draw::pooled_f(scores));
    if (std::all_of(scores.begin(), scores.end(), is_scored)) return;
    fmt::print(stderr, "inkbench: some images have no score\n");
    throw CLI::RuntimeError(std::any_of(scores.begin(), scores.end(), is_scored) ? kImagesUnscored
                                                                                 : kFTooLow);
}

void run_score(ScoreArguments a) {
    a.request.options.thin = !a.no_thin;
    a.request.polarity = asked_polarity(a);
    a.request.intersections = a.options.read().intersections;
    if (a.fail_under && !(*a.fail_under >= 0 && *a.fail_under <= 1)) {
        throw core::Error(
            "--fail-under", fmt::format("{} is no value of F", *a.fail_under), "0..1");
    }
    if (!a.csv.empty()) check_output_path(a.csv, {".csv"});
    const bool is_folder = fs::is_directory(a.prediction);
    if (is_folder != fs::is_directory(a.truth)) {
        throw core::Error(
            (is_folder ? a.truth : a.prediction).string(),
            "this is no folder, but " + (is_folder ? a.prediction : a.truth).string() + " is one",
            "two files, or two folders");
    }
    return is_folder ? score_all(a) : score_pair(a);
}

void add_scoring_options(CLI::App& command, ScoreArguments& a) {
    command
        .add_option("--tol",
                    a.request.options.tolerance_px,
                    "Matched pixels are at most this far apart, at most 8")
        ->type_name("PX")
        ->capture_default_str();
    command
        .add_option("--threshold",
                    a.request.options.threshold,
                    "Edge response of a predicted pixel, 1..255")
        ->capture_default_str();
    command
        .add_option("--polarity",
                    a.polarity,
                    "Lines are light on dark, dark on light, or auto: dark where more than three "
                    "quarters of the image are light")
        ->capture_default_str();
    command.add_flag("--invert", a.is_inverted, "The same as --polarity dark");
    command.add_flag("--no-thin", a.no_thin, "Do not thin the prediction");
    command
        .add_option("--band",
                    a.request.band_px,
                    "Leave out this many pixels along the frame (default: what an EXR says, else "
                    "0)")
        ->type_name("PX");
    command.add_option("--ignore",
                       a.request.options.ignore_label,
                       "Truth value, 1..255, that is neither required nor penalised (default: what "
                       "an EXR says, else none)");
    a.options.add_to(command, {"measure.intersections"});
}

}  // namespace

void add_score_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "score", "Score an outline image against a truth image, or a folder of them");
    auto a = std::make_shared<ScoreArguments>();
    command->add_option("prediction", a->prediction, "8-bit outline image, or a folder of them")
        ->type_name("FILE")
        ->required();
    command
        ->add_option(
            "truth",
            a->truth,
            "What inkbench truth -o writes: the .exr, or the 8-bit image of classes (0 no line, "
            "every other value a class; if it holds nothing but 0 and 1, or 0 and 255, its lines "
            "have no class). Or a folder of them, with the names of the predictions")
        ->type_name("FILE")
        ->required();
    add_scoring_options(*command, *a);
    command
        ->add_option("--picture",
                     a->picture,
                     "PNG of what is right, missing and false; of folders: a folder for them")
        ->type_name("FILE");
    command->add_option("--csv", a->csv, "CSV with a line per image")->type_name("FILE");
    command
        ->add_option("--fail-under",
                     a->fail_under,
                     "Exit with 1 if F (of folders: pooled) is "
                     "below this")
        ->type_name("F");
    command->add_flag("--json", a->as_json, "Print JSON instead of a table");
    command->footer(
        "Example: inkbench score pred.png truth.exr --tol 1 --json\n"
        "compare scores with the ignore label and band of the .exr, and each method's own "
        "--threshold.\n"
        "Exit codes: 0 done, 1 F is below --fail-under or no image of a folder has a score, 2 bad "
        "input, 3 some\nimages of a folder have no score.");
    command->callback([a] { run_score(*a); });
}

}  // namespace ink::cli
