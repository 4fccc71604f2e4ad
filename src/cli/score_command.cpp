#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/commands.h"
#include "draw/score_files.h"

namespace ink::cli {
namespace {

/// The command line of `score`.
struct ScoreArguments {
    draw::ScoreRequest request;
    bool no_thin = false;
    bool as_json = false;
};

/// null where there is no value: neither 0 nor NaN, which would slip into a mean.
nlohmann::ordered_json number_or_null(std::optional<double> value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

std::optional<double> mean_width(const score::Score& s) {
    return s.mean_width_px > 0 ? std::optional(s.mean_width_px) : std::nullopt;
}

std::string json_text(const score::Score& s) {
    nlohmann::ordered_json json = {
        {"k", s.k},
        {"n_pred", s.n_pred},
        {"n_truth", s.n_truth},
        {"f", s.f()},
        {"precision", number_or_null(s.precision())},
        {"recall", number_or_null(s.recall())},
        // Scripts rely on these keys, also where columns have other names.
        {"surplus", s.unmatched_duplicates},
        {"off_line", s.false_positives},
        {"lost", s.unmatched_truth},
        {"missing", s.false_negatives},
        {"mean_width", number_or_null(mean_width(s))},
        {"classes", nlohmann::ordered_json::object()},
    };
    for (const score::ClassCount& c : s.classes) {
        json["classes"][std::to_string(c.label)] = {{"k", c.k}, {"n_truth", c.n_truth}};
    }
    return json.dump(2) + "\n";
}

std::string four_places(std::optional<double> value) {
    return value ? fmt::format("{:.4f}", *value) : "-";
}

std::string table_text(const draw::ScoreRequest& request, const score::Score& s) {
    std::string text = fmt::format("{} against {}\n",
                                   request.prediction.filename().string(),
                                   request.truth.filename().string());
    text += fmt::format("within {} px, edge response {} and above, {}\n\n",
                        request.options.tolerance_px,
                        request.options.threshold,
                        request.options.thin ? "thinned" : "not thinned");
    text += fmt::format("  F           {:.4f}\n", s.f());
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
    if (s.classes.empty()) return text;
    text += fmt::format("\n  {:<16} {:>6} {:>9} {:>9}\n", "class", "recall", "matched", "true");
    for (const score::ClassCount& c : s.classes) {
        text += fmt::format("  {:<16} {:>6.4f} {:>9} {:>9}\n",
                            draw::label_text(c.label),
                            static_cast<double>(c.k) / static_cast<double>(c.n_truth),
                            c.k,
                            c.n_truth);
    }
    return text;
}

void run_score(ScoreArguments a) {
    a.request.options.thin = !a.no_thin;
    const draw::FilesScore result = draw::score_files(a.request);
    fmt::print("{}", a.as_json ? json_text(result.score) : table_text(a.request, result.score));
    for (const std::string& doubt : result.doubts)
        fmt::print(stderr, "inkbench: {}\n", doubt);
}

}  // namespace

void add_score_command(CLI::App& app) {
    auto* command = app.add_subcommand("score", "Score an outline image against a truth image");
    auto a = std::make_shared<ScoreArguments>();
    command
        ->add_option(
            "prediction", a->request.prediction, "8-bit image: 0 no line .. 255 the strongest")
        ->type_name("FILE")
        ->required();
    command
        ->add_option(
            "truth",
            a->request.truth,
            "8-bit image of classes, as inkbench truth -o writes it: 0 no line, every other value "
            "a class. If it holds nothing but 0 and 1, or 0 and 255, its lines have no class")
        ->type_name("FILE")
        ->required();
    command
        ->add_option(
            "--tol", a->request.options.tolerance_px, "Matched pixels are at most this far apart")
        ->type_name("PX")
        ->capture_default_str();
    command
        ->add_option("--threshold",
                     a->request.options.threshold,
                     "Edge response of a predicted pixel, 1..255")
        ->capture_default_str();
    command->add_flag("--invert", a->request.is_inverted, "The prediction has dark lines on light");
    command->add_flag("--no-thin", a->no_thin, "Do not thin the prediction");
    command
        ->add_option(
            "--band", a->request.options.band_px, "Leave out this many pixels along the frame")
        ->type_name("PX")
        ->capture_default_str();
    command->add_option("--ignore",
                        a->request.options.ignore_label,
                        "Truth value, 1..255, that is neither required nor penalised");
    command->add_flag("--json", a->as_json, "Print JSON instead of a table");
    command->footer(
        "Example: inkbench score pred.png truth.png --tol 1 --json\n"
        "compare scores with --ignore 7 --band 6 and each method's own --threshold.\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([a] { run_score(*a); });
}

}  // namespace ink::cli
