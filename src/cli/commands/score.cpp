#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/tables/csv_table.h"
#include "core/text_table.h"
#include "core/whole_file.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "given_images/score_files.h"
#include "harness/images/view_images.h"
#include "image_io/image_file.h"
#include "score/coverage.h"

namespace ink::cli {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> mean_width(const score::Score& s) {
    return s.mean_width_px > 0 ? std::optional(s.mean_width_px) : std::nullopt;
}

std::string four_places(std::optional<double> value) {
    return value ? fmt::format("{:.4f}", *value) : "-";
}

/// Numbers by their columns; null where there is none.
using Numbers = std::vector<std::pair<const char*, Json>>;

Numbers numbers_of(const score::Score& s) {
    return {{"f", or_null(s.f_of_truth())},
            {"precision", or_null(s.precision())},
            {"recall", or_null(s.recall())},
            {"k", s.k},
            {"n_pred", s.n_pred},
            {"n_truth", s.n_truth},
            {"unmatched_duplicates", s.unmatched_duplicates},
            {"false_positives", s.false_positives},
            {"unmatched_truth", s.unmatched_truth},
            {"false_negatives", s.false_negatives},
            {"mean_width_px", or_null(mean_width(s))}};
}

/// Those of grey lines, by the names of rows.csv.
Numbers numbers_of(const score::SoftScore& soft) {
    return {{"soft_f", or_null(soft.f())},
            {"ink_line_width_px", soft.line_width_px},
            {"ink_matched_px", soft.matched_px},
            {"ink_misplaced_px", soft.misplaced_px},
            {"ink_surplus_px", soft.surplus_px},
            {"ink_missing_px", soft.missing_px}};
}

Json scored_json(const score::Score& s, const std::optional<score::SoftScore>& soft) {
    Json result = Json::object();
    for (const auto& [name, value] : numbers_of(s))
        result[name] = value;
    // The names of before.
    result["surplus"] = s.unmatched_duplicates;
    result["off_line"] = s.false_positives;
    result["lost"] = s.unmatched_truth;
    result["missing"] = s.false_negatives;
    result["mean_width"] = or_null(mean_width(s));
    result["classes"] = Json::object();
    result["class_names"] = Json::object();
    for (const score::ClassCount& c : s.classes) {
        const std::string label = std::to_string(c.label);
        result["classes"][label] = {{"k", c.k}, {"n_truth", c.n_truth}};
        result["class_names"][label] = given_images::label_text(c.label);
    }
    if (!soft) return result;
    for (const auto& [name, value] : numbers_of(*soft))
        result[name] = value;
    return result;
}

/// As in all tables; nothing for null.
std::string csv_text(const Json& value) {
    if (value.is_null()) return "";
    return value.is_number_float() ? fmt::format("{}", value.get<double>()) : value.dump();
}

std::string ink_lines(const score::SoftScore& soft) {
    return fmt::format(
        "\n  soft F      {:>6}   of grey lines {} px wide; in px^2:\n"
        "  {:.1f} drawn = {:.1f} matched + {:.1f} misplaced + {:.1f} surplus\n"
        "  {:.1f} true = {:.1f} matched + {:.1f} misplaced + {:.1f} missing\n",
        four_places(soft.f()),
        soft.line_width_px,
        soft.drawn_px(),
        soft.matched_px,
        soft.misplaced_px,
        soft.surplus_px,
        soft.true_px(),
        soft.matched_px,
        soft.misplaced_px,
        soft.missing_px);
}

/// One score as JSON, with the names of folder_csv's columns. The names of before stand beside
/// them: surplus, off_line, lost, missing, mean_width.
std::string score_json(const given_images::FilesScore& scored) {
    Json result = scored_json(scored.score, scored.soft);
    result["polarity"] = scored.is_inverted ? "dark" : "light";
    result["band"] = scored.options.band_px;
    result["ignore"] =
        scored.options.ignore_label ? Json(*scored.options.ignore_label) : Json(nullptr);
    result["notes"] = scored.notes;
    result["doubts"] = scored.doubts;
    return result.dump(2) + "\n";
}

/// One score as a table for a terminal.
std::string score_table(const std::filesystem::path& prediction,
                        const std::string& truth_name,
                        const given_images::FilesScore& scored) {
    const score::Score& s = scored.score;
    const score::ScoreOptions& options = scored.options;
    std::string text = fmt::format("{} against {}\n", prediction.filename().string(), truth_name);
    text += fmt::format("within {} px, {}, edge response {} and above, {}",
                        options.tolerance_px,
                        scored.is_inverted ? "dark lines on light" : "light lines on dark",
                        options.threshold,
                        options.thin ? "thinned" : "not thinned");
    if (options.band_px > 0) text += fmt::format(", {} px of the frame left out", options.band_px);
    if (options.ignore_label) text += fmt::format(", {} ignored", *options.ignore_label);
    if (!scored.notes.empty()) text += fmt::format("\nread as: {}", fmt::join(scored.notes, "; "));
    text += fmt::format("\n\n  F           {:>6}\n", four_places(s.f_of_truth()));
    text += fmt::format(
        "  precision   {:>6}   {} predicted = {} matched + {} unmatched duplicates + {} false "
        "positives\n",
        four_places(s.precision()),
        s.n_pred,
        s.k,
        s.unmatched_duplicates,
        s.false_positives);
    text += fmt::format(
        "  recall      {:>6}   {} true = {} matched + {} unmatched truth + {} false negatives\n",
        four_places(s.recall()),
        s.n_truth,
        s.k,
        s.unmatched_truth,
        s.false_negatives);
    text += fmt::format("  mean width  {:>6} px\n",
                        s.mean_width_px > 0 ? fmt::format("{:.2f}", s.mean_width_px) : "-");
    if (scored.soft) text += ink_lines(*scored.soft);
    if (s.classes.empty()) return text;
    text += fmt::format("\n  {:<16} {:>6} {:>9} {:>9}\n", "class", "recall", "matched", "true");
    for (const score::ClassCount& c : s.classes) {
        text += fmt::format("  {:<16} {:>6.4f} {:>9} {:>9}\n",
                            given_images::label_text(c.label),
                            static_cast<double>(c.k) / static_cast<double>(c.n_truth),
                            c.k,
                            c.n_truth);
    }
    return text;
}

/// The scores of a folder: a line each, then all of them pooled, and what has no score. For a
/// terminal, or as Markdown.
std::string folder_table(const std::vector<given_images::FolderScore>& scores,
                         bool is_markdown = false) {
    const char* const item = is_markdown ? "- " : "";
    core::Cells cells{{"image", "F", "precision", "recall", "predicted", "true"}};
    std::map<std::string, std::string> read_as;  // the images by how they were read
    std::string unscored;
    for (const given_images::FolderScore& each : scores) {
        if (!each.score) {
            unscored += fmt::format("{}no score: {}: {}\n", item, each.name, each.status);
            continue;
        }
        if (!each.notes.empty()) {
            std::string& names = read_as[fmt::format("{}", fmt::join(each.notes, "; "))];
            names += (names.empty() ? "" : ", ") + each.name;
        }
        cells.push_back({each.name,
                         four_places(each.score->f()),
                         four_places(each.score->precision()),
                         four_places(each.score->recall()),
                         std::to_string(each.score->n_pred),
                         std::to_string(each.score->n_truth)});
    }
    const score::CurveCount all = given_images::pooled(scores);
    cells.push_back({"all, pooled",
                     four_places(given_images::pooled_f(scores)),
                     "",
                     "",
                     std::to_string(all.n_pred),
                     std::to_string(all.n_truth)});
    std::string text = is_markdown ? core::markdown(cells) + "\n" : core::aligned(cells);
    text += unscored;
    for (const auto& [how, names] : read_as)
        text += fmt::format("{}read as {}: {}\n", item, how, names);
    return text;
}

/// The same as JSON: {"images": {name: score or {"status"}}, "pooled": ..., "unmatched": [files]}.
std::string folder_json(const std::vector<given_images::FolderScore>& scores,
                        const std::vector<std::string>& unmatched) {
    Json result = {{"images", Json::object()}};
    for (const given_images::FolderScore& each : scores) {
        Json image = each.score ? scored_json(*each.score, each.soft) : Json::object();
        image["status"] = each.status;
        if (each.score) {
            image["notes"] = each.notes;
            image["doubts"] = each.doubts;
        }
        result["images"][each.name] = std::move(image);
    }
    const score::CurveCount all = given_images::pooled(scores);
    result["pooled"] = {{"k", all.k},
                        {"n_pred", all.n_pred},
                        {"n_truth", all.n_truth},
                        {"f", or_null(given_images::pooled_f(scores))}};
    result["unmatched"] = unmatched;
    return result.dump(2) + "\n";
}

/// The same as CSV, a line per image; the ink of grey lines by the names of rows.csv.
std::string folder_csv(const std::vector<given_images::FolderScore>& scores) {
    const bool has_ink =
        std::ranges::any_of(scores, [](const auto& each) { return each.soft.has_value(); });
    const auto numbers_of_all = [&](const given_images::FolderScore& each) {
        Numbers numbers = numbers_of(each.score.value_or(score::Score{}));
        if (!has_ink) return numbers;
        for (auto& number : numbers_of(each.soft.value_or(score::SoftScore{})))
            numbers.push_back(each.soft ? std::move(number) : std::pair(number.first, Json()));
        return numbers;
    };
    std::string text = "image,status";
    for (const auto& [name, value] : numbers_of_all({}))
        text += fmt::format(",{}", name);
    text += "\n";
    for (const given_images::FolderScore& each : scores) {
        text += core::csv_field(each.name) + "," + core::csv_field(each.status);
        for (const auto& [name, value] : numbers_of_all(each))
            text += "," + (each.score ? csv_text(value) : "");
        text += "\n";
    }
    return text;
}

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
