#include "tune/tune_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "core/hash.h"
#include "core/toml_document.h"
#include "core/whole_file.h"
#include "experiment/dictionary.h"
#include "experiment/experiment_run.h"
#include "harness/cells/cell.h"
#include "harness/images/view_images.h"
#include "harness/rows/methods_table.h"
#include "harness/rows/row_table.h"
#include "harness/scores/evaluations.h"
#include "methods/presets.h"
#include "statistics/bootstrap.h"
#include "summary/paired_differences.h"

namespace ink::tune {
namespace {

std::string interval_text(const std::optional<statistics::Interval>& interval) {
    // Of the error: what is high in F is low in E.
    return interval ? fmt::format("[{:.4f}, {:.4f}]", 1 - interval->high, 1 - interval->low) : "-";
}

/// In the order of TuneObjective.
constexpr std::array kObjectiveWords = {"the error at 2 px",
                                        "the scenes' errors at 2 px",
                                        "the errors of kinds of scenes at 2 px",
                                        "the error of the worst kind of scenes at 2 px",
                                        "the error less what is gained evenly at 2 px"};

std::string error_line(const TunedSettings& each) {
    const double train = 1 - f_of(each.train), heldout = 1 - f_of(each.heldout);
    const auto cells = [](double error, const std::vector<score::CurveCount>& scenes) {
        const std::string range = interval_text(statistics::f_interval(scenes, {}));
        return fmt::format(" {:>7.4f} {:>6.3f} {:<18}", error, 1 - error, range);
    };
    const std::string line = fmt::format("{:<24}{}", each.name, cells(train, each.train));
    if (each.heldout.empty()) return line + "\n";
    return line + cells(heldout, each.heldout) + fmt::format(" {:>+8.4f}\n", heldout - train);
}

std::string paired_difference_line(const char* where,
                                   const std::vector<score::CurveCount>& a,
                                   const std::vector<score::CurveCount>& b) {
    const summary::PairedDifference paired{
        "", "", f_of(a) - f_of(b), statistics::paired_interval(a, b, {})};
    const char* verdict = "";
    if (paired.range) verdict = paired.is_significant() ? ": significant" : ": not significant";
    return fmt::format(
        "  on {} scenes {}{}\n", where, summary::format_paired_difference(paired), verdict);
}

/// What settings found so may score on a view, or a kind, that the search has not seen.
std::string left_out_line(const TuneResult& result, const TuneOptions& options) {
    if (result.left_out.empty()) return "";
    const double f = f_of(result.left_out);
    return fmt::format(
        "one {} left out at a time: E {:.4f}, F {:.3f}, interval of E {} over {} views\n",
        is_by_kind(options.objective) ? "kind" : "view",
        1 - f,
        f,
        interval_text(statistics::f_interval(result.left_out, {})),
        result.left_out.size());
}

/// Who drew the search's settings, and how much it matters.
std::string agreement_line(const TuneResult& result) {
    if (!result.agreement) return "";
    const auto n_planes = std::ranges::count_if(
        result.steps, [](const TuneStep& step) { return step.found.is_by_planes; });
    const PlaneAgreement& agreement = *result.agreement;
    return fmt::format(
        "{} of {} evaluations took a short cut; every new best was checked with the whole method\n "
        " "
        "at the tuned settings {:.4f} % of the pixels differ, E by {:+.6f}\n\n",
        n_planes,
        result.steps.size(),
        100.0 * static_cast<double>(agreement.differ_px) /
            static_cast<double>(std::max<std::int64_t>(agreement.total_px, 1)),
        f_of(result.tuned.train) - f_of(agreement.by_planes));
}

/// "+.012": by how much the first F exceeds the second.
std::string gain_text(const std::vector<score::CurveCount>& a,
                      const std::vector<score::CurveCount>& b) {
    return summary::format_paired_difference({"", "", f_of(a) - f_of(b), std::nullopt});
}

/// "knight", "knight, cube", "18 scenes".
std::string unseen_text(const std::vector<TunedScene>& scenes) {
    constexpr std::size_t kNamed = 2;
    if (scenes.size() > kNamed) return fmt::format("{} scenes", scenes.size());
    return scenes.front().name + (scenes.size() == kNamed ? ", " + scenes.back().name : "");
}

/// What a gain on scenes that the search has not seen comes to.
const char* advice_on(const std::vector<score::CurveCount>& tuned,
                      const std::vector<score::CurveCount>& defaults) {
    const double gain = f_of(tuned) - f_of(defaults);
    const auto range = statistics::paired_interval(tuned, defaults, {});
    if (gain < 0) return "do not ship";
    if (gain == 0) return "nothing gained there";
    if (!range) return "better there, too, on too few scenes to be sure";
    return range->low > 0 ? "ship" : "better there, too, but not surely";
}

std::string settings_lines(const TuneResult& result, const TuneOptions& options) {
    std::string text;
    const core::ParamValues defaults = options.config.info->complete(options.config.settings);
    for (const auto& [name, value] : result.tuned.settings)
        text += fmt::format("  {:<16} {:>10} -> {}\n", name, defaults.at(name), value);
    return text;
}

std::string asked_text(const TuneOptions& options, const TuneSpace& space) {
    toml::table parameters;
    for (const auto& [name, value] : options.config.info->complete(options.config.settings))
        parameters.insert(name, value);
    toml::table searched;
    for (const TunedParameter& parameter : space.parameters())
        searched.insert(parameter.param.name, toml::array{parameter.low, parameter.high});
    std::ostringstream text;
    text << toml::table{
        {"methods", toml::table{{options.config.info->name, std::move(parameters)}}},
        {"search",
         toml::table{{"parameters", std::move(searched)},
                     {"evaluations", options.plan.evaluations},
                     {"seed", static_cast<std::int64_t>(options.plan.seed)},
                     {"global", options.plan.global},
                     {"random", options.random}}}};
    return text.str();
}

experiment::RunRecord record_of(const TuneOptions& options, const TuneSpace& space) {
    experiment::RunRecord record;
    record.name = options.name;
    record.kind = "tune";
    record.command = options.command;
    record.asked = asked_text(options, space);
    record.identity =
        core::Hasher().text(record.build).text(record.command).text(record.asked).hex();
    record.add_table(harness::rows_table());
    record.add_table(evaluations_table(space));
    record.blocks = 1;
    record.cells = options.plan.evaluations * (options.random ? 2 : 1);
    return record;
}

/// One setting of the method on one scene, all its views taken together.
struct SceneRow {
    const TunedSettings& settings;
    const TunedScene& scene;
    const score::CurveCount& count;
};

std::string line_of(std::int64_t cell, const SceneRow& of, const TuneOptions& options) {
    const method::MethodConfig config = method::with(options.config, of.settings.settings);
    harness::Row row;
    row.method = of.settings.name;
    row.scene = of.scene.name;
    row.view = "(all)";
    row.split = scene::split_name(of.scene.split);
    row.scene_kind = of.scene.kind;
    row.threads = options.threads;
    row.seed = options.plan.seed;
    row.params = harness::join_params(config.info->complete(config.settings));
    harness::fill_truth_settings(options.trace, row);
    row.k_2px = of.count.k;
    row.n_pred = of.count.n_pred;
    row.n_truth = of.count.n_truth;
    row.f_2px = of.count.f();
    const auto share = [&](std::int64_t of_px) -> std::optional<double> {
        if (of_px == 0) return std::nullopt;
        return static_cast<double>(of.count.k) / static_cast<double>(of_px);
    };
    row.precision_2px = share(of.count.n_pred);
    row.recall_2px = share(of.count.n_truth);
    return harness::row_line(cell, harness::Study::tune, row);
}

std::string rows_csv(const TuneResult& result, const TuneOptions& options) {
    std::string text = core::heading(harness::rows_table());
    std::vector<const TunedSettings*> all = {&result.defaults, &result.tuned};
    if (result.random) all.push_back(&*result.random);
    std::int64_t cell = 0;
    for (const TunedSettings* each : all) {
        for (std::size_t i = 0; i < each->train.size(); ++i)
            text += line_of(cell++, {*each, result.train_scenes[i], each->train[i]}, options);
        for (std::size_t i = 0; i < each->heldout.size(); ++i)
            text += line_of(cell++, {*each, result.heldout_scenes[i], each->heldout[i]}, options);
    }
    return text;
}

/// evaluations.csv, heading included.
std::string evaluations_csv(const TuneResult& result, const TuneSpace& space) {
    std::string text = core::heading(evaluations_table(space));
    for (const auto* steps : {&result.steps, &result.random_steps}) {
        for (std::size_t i = 0; i < steps->size(); ++i) {
            const TuneStep& step = (*steps)[i];
            text += fmt::format("{},{}", i + 1, step.phase);
            for (const TunedParameter& parameter : space.parameters())
                text += "," + step.settings.at(parameter.param.name);
            text += fmt::format(
                ",{},{}", step.found.error, step.found.is_by_planes ? "planes" : "method");
            text += step.found.draw_ms ? fmt::format(",{}\n", *step.found.draw_ms) : ",\n";
        }
    }
    return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> provenance_lines(const TuneResult& result,
                                                                  const TuneOptions& options) {
    std::vector<std::pair<std::string, std::string>> lines = {
        {"command", methods::toml_text(options.command)},
        {"seed", fmt::format("{}", options.plan.seed)},
        {"objective", methods::toml_text(std::string(name(options.objective)))},
        {"evaluations", fmt::format("{}", result.steps.size())},
        {"training_views", fmt::format("{}", result.train_views)},
        {"e_train", fmt::format("{:.6f}", 1 - f_of(result.tuned.train))},
        {"e_train_default", fmt::format("{:.6f}", 1 - f_of(result.defaults.train))}};
    if (result.heldout_views > 0) {
        lines.push_back({"heldout_views", fmt::format("{}", result.heldout_views)});
        lines.push_back({"e_heldout", fmt::format("{:.6f}", 1 - f_of(result.tuned.heldout))});
        lines.push_back(
            {"e_heldout_default", fmt::format("{:.6f}", 1 - f_of(result.defaults.heldout))});
    }
    if (!result.left_out.empty())
        lines.push_back({"e_left_out", fmt::format("{:.6f}", 1 - f_of(result.left_out))});
    if (options.budget_ms) lines.push_back({"budget_ms", fmt::format("{}", *options.budget_ms)});
    lines.push_back({"inputs", methods::toml_text(result.inputs_hash)});
    return lines;
}

std::string tune_finding(const TuneResult& result, const TuneOptions& options) {
    const TunedSettings& tuned = result.tuned;
    const TunedSettings& defaults = result.defaults;
    const std::string found = fmt::format(
        "{}: F {} where it searched", options.name, gain_text(tuned.train, defaults.train));
    if (!tuned.heldout.empty()) {
        return fmt::format("{}, {} on {}: {}",
                           found,
                           gain_text(tuned.heldout, defaults.heldout),
                           unseen_text(result.heldout_scenes),
                           advice_on(tuned.heldout, defaults.heldout));
    }
    if (result.left_out.empty()) return found + "; what it does elsewhere is not known";
    return fmt::format(
        "{}, {} on what was left out in turns: {}",
        found,
        gain_text(result.left_out, defaults.train),
        f_of(result.left_out) < f_of(defaults.train) ? "do not ship" : "try it on other scenes");
}

std::string tune_summary(const TuneResult& result, const TuneOptions& options) {
    std::string text = fmt::format(
        "{}: {} evaluations of {} over {} views of {} training scenes, seed {}{}\n\n",
        options.config.info->name,
        result.steps.size(),
        kObjectiveWords.at(static_cast<std::size_t>(options.objective)),
        result.train_views,
        result.tuned.train.size(),
        options.plan.seed,
        result.resumed > 0 ? fmt::format(" ({} were on disk already)", result.resumed) : "");
    text += fmt::format("{:<24} {:>7} {:>6} {:<18}", "", "E train", "F", "interval of E");
    if (result.heldout_views > 0) {
        text += fmt::format(" {:>7} {:>6} {:<18} {:>8}", "unseen", "F", "interval of E", "gap");
    }
    text += '\n';
    text += error_line(result.defaults);
    text += error_line(result.tuned);
    if (result.random) text += error_line(*result.random);
    text += fmt::format(
        "\npaired difference of {} and {} in F:\n", options.name, options.config.info->name);
    text += paired_difference_line("training", result.tuned.train, result.defaults.train);
    if (result.heldout_views > 0) {
        text += paired_difference_line("unseen", result.tuned.heldout, result.defaults.heldout);
    }
    text += left_out_line(result, options);
    const bool is_late = options.budget_ms && result.tuned.found.value > 1;
    if (is_late) text += "no setting keeps within the time budget\n";
    if (options.budget_ms) {
        text += fmt::format("median drawing {:.3f} ms of {} allowed\n",
                            result.tuned.found.draw_ms.value_or(0),
                            *options.budget_ms);
    }
    text += '\n';
    text += agreement_line(result);
    text += settings_lines(result, options);
    text += fmt::format("\n{}\npreset: {}\nevaluations: {}\n",
                        tune_finding(result, options),
                        result.preset.string(),
                        (options.out / "evaluations.csv").string());
    return text;
}

core::TableInfo evaluations_table(const TuneSpace& space) {
    std::vector<std::string> names;
    for (const TunedParameter& parameter : space.parameters())
        names.push_back(parameter.param.name);
    return experiment::evaluations_table(names);
}

void begin_folder(const TuneOptions& options,
                  const TuneSpace& space,
                  const std::vector<harness::SceneViews>& scenes) {
    harness::make_out_folder(options.out);
    experiment::RunRecord mine = record_of(options, space);
    for (const harness::SceneViews& scene_views : scenes)
        mine.add_model(scene_views.scene);
    experiment::take_folder(options.out, mine, options.is_forced);
    experiment::write_record(mine, options.out);
}

void finish_folder(const TuneResult& result, const TuneOptions& options, const TuneSpace& space) {
    core::write_whole_file(options.out / "rows.csv", rows_csv(result, options));
    core::write_whole_file(options.out / "evaluations.csv", evaluations_csv(result, space));
    core::write_whole_file(options.out / "methods.csv", harness::methods_csv({options.config}));
    experiment::RunRecord record = record_of(options, space);
    if (auto begun = experiment::read_record(options.out)) record.models = std::move(begun->models);
    record.finding = tune_finding(result, options);
    record.state = experiment::RunState::finished;
    record.blocks_done = record.blocks;
    experiment::write_record(record, options.out);
}

}  // namespace ink::tune
