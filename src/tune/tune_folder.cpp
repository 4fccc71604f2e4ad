#include "tune/tune_report.h"

#include <sstream>
#include <utility>

#include "core/hash.h"
#include "core/toml_document.h"
#include "core/whole_file.h"
#include "experiment/dictionary.h"
#include "experiment/experiment_run.h"
#include "harness/cells/cell.h"
#include "harness/images/out_folder.h"
#include "harness/rows/methods_table.h"
#include "harness/rows/row_table.h"
#include "harness/scores/evaluations.h"

namespace ink::tune {
namespace {

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

}  // namespace

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
