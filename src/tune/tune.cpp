#include "tune/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/whole_file.h"
#include "harness/cells/cell.h"
#include "methods/presets.h"
#include "tune/tune_report.h"

namespace ink::tune {
namespace {

/// Thrown between two evaluations after Ctrl-C.
struct Interrupted {};

using method::with;

/// A search under way: answers the optimiser from what is known, from the disk or by drawing.
class Tuner {
  public:
    Tuner(const TuneOptions& options, const TuneSpace& space, TuneBench& bench, TuneLog& log)
        : options_(options),
          space_(space),
          bench_(bench),
          log_(log),
          has_planes_(!options.budget_ms && bench.planes().can_search(options.config, space)),
          progress_("tune", options.plan.evaluations * (options.random ? 2 : 1)) {}

    [[nodiscard]] TuneValue value_of(const core::ParamValues& settings) {
        return value_by(settings, DrawnBy::method);
    }

    /// An objective that notes its evaluations in `steps`.
    [[nodiscard]] search::SearchObjective into(std::vector<TuneStep>& steps) {
        tried_.clear();
        best_ = 2;
        return [this, &steps](const char* phase, const std::vector<double>& point) {
            const core::ParamValues settings = space_.settings_at(point);
            const auto known = tried_.find(settings);
            if (known != tried_.end()) return search::SearchValue{known->second, false};
            progress_.report(done_++, progress_text(phase));
            const TuneValue found = candidate(settings);
            best_ = std::min(best_, found.value);
            tried_[settings] = found.value;
            steps.push_back({phase, settings, found});
            return search::SearchValue{found.value, true};
        };
    }

  private:
    /// Where it looks, and how good the best is.
    [[nodiscard]] std::string progress_text(std::string_view phase) const {
        const char* where = phase == "local"    ? "near the best"
                            : phase == "global" ? "in the whole space"
                                                : "at random";
        const std::string best = best_ > 1 ? "" : fmt::format(", least error {:.4f}", best_);
        return phase == "start" ? "at the start" + best : where + best;
    }

    /// By planes where that can be, unless it may be the best yet: that the method itself decides.
    /// Hangs on the search alone and on nothing that is on disk already.
    [[nodiscard]] TuneValue candidate(const core::ParamValues& settings) {
        if (has_planes_ && bench_.planes().can_draw(with(options_.config, settings))) {
            const TuneValue found = value_by(settings, DrawnBy::planes);
            if (found.value >= best_) return found;
        }
        return value_by(settings, DrawnBy::method);
    }

    [[nodiscard]] TuneValue value_by(const core::ParamValues& settings, DrawnBy by) {
        const bool is_by_planes = by == DrawnBy::planes;
        const std::string key = (is_by_planes ? "planes;" : "") + harness::join_params(settings);
        std::optional<TuneValue> found = log_.find(key);
        if (!found) {
            if (core::is_interrupted()) throw Interrupted();
            found = measured(with(options_.config, settings), by);
            log_.add(key, *found);
        }
        found->is_by_planes = is_by_planes;
        return *found;
    }

    [[nodiscard]] TuneValue measured(const method::MethodConfig& config, DrawnBy by) {
        TuneValue found;
        found.by_view = bench_.view_counts(config, by);
        found.error = error_of(found.by_view, bench_.tune_views(), options_.objective);
        found.value = found.error;
        if (!options_.budget_ms) return found;
        found.draw_ms = bench_.draw_ms();
        if (*found.draw_ms > *options_.budget_ms) {
            found.value = 1 + *found.draw_ms / *options_.budget_ms;
        }
        return found;
    }

    const TuneOptions& options_;
    const TuneSpace& space_;
    TuneBench& bench_;
    TuneLog& log_;
    bool has_planes_;  ///< a time is the method's own
    core::Progress progress_;
    std::map<core::ParamValues, double> tried_;
    double best_ = 2;
    int done_ = 0;
};

const TuneStep& best_of(const std::vector<TuneStep>& steps) {
    return *std::ranges::min_element(
        steps, [](const auto& a, const auto& b) { return a.found.value < b.found.value; });
}

/// All that a result of the search depends on.
std::string key_of(const TuneOptions& options, const TuneSpace& space, const std::string& inputs) {
    core::Hasher hasher;
    hasher.text(options.command).text(inputs).text(options.config.info->name);
    hasher.text(harness::join_params(options.config.info->complete(options.config.settings)));
    for (const TunedParameter& parameter : space.parameters())
        hasher.text(parameter.param.name).value(parameter.low).value(parameter.high);
    return hasher.hex();
}

TuneSpace checked_space(const TuneOptions& options) {
    TuneSpace space(*options.config.info, options.parameters);
    for (const TunedParameter& parameter : space.parameters()) {
        if (options.config.settings.count(parameter.param.name) == 0) continue;
        throw core::Error("--set",
                          fmt::format("{} is tuned", parameter.param.name),
                          "parameters that --params does not name");
    }
    return space;
}

/// The parameters' values among all settings of `config`.
core::ParamValues parameters_of(const method::MethodConfig& config, const TuneSpace& space) {
    const core::ParamValues all = config.info->complete(config.settings);
    core::ParamValues parameters;
    for (const TunedParameter& parameter : space.parameters())
        parameters[parameter.param.name] = all.at(parameter.param.name);
    return parameters;
}

void write_results(const TuneOptions& options, const TuneSpace& space, TuneResult& result) {
    const methods::PresetFile file{options.name,
                                   options.config.info,
                                   with(options.config, result.tuned.settings).settings,
                                   provenance_lines(result, options)};
    result.preset = options.out / (options.name + ".toml");
    core::write_whole_file(result.preset, methods::preset_toml(file));
    finish_folder(result, options, space);
}

}  // namespace

TuneResult tune(std::vector<harness::SceneViews> scenes, const TuneOptions& options) {
    const core::InterruptGuard guard;
    const TuneSpace space = checked_space(options);
    const auto middle = std::stable_partition(scenes.begin(), scenes.end(), [&](auto& scene_views) {
        return scene_views.scene.split != scene::Split::heldout &&
               options.unseen.count(scene_views.scene.name) == 0;
    });
    const std::vector<harness::SceneViews> train(scenes.begin(), middle);
    const std::vector<harness::SceneViews> heldout(middle, scenes.end());
    if (train.empty()) {
        throw core::Error("--scenes",
                          "none of them may be searched: all are held out",
                          "a model file, or one of those that inkbench list scenes calls training");
    }
    begin_folder(options, space, scenes);

    TuneResult result;
    for (const auto& of : train)
        result.train_scenes.push_back({of.scene.name, scene::Split::train, of.scene.kind});
    for (const auto& of : heldout)
        result.heldout_scenes.push_back({of.scene.name, of.scene.split, of.scene.kind});
    TuneBench bench(train, options.trace, options.threads);
    if (core::is_interrupted()) {
        result.is_interrupted = true;
        return result;
    }
    if (options.budget_ms) bench.take_times();
    result.train_views = bench.view_count();
    result.inputs_hash = bench.hash();
    TuneLog log(options.out / "evaluations.csv.part", key_of(options, space, bench.hash()));
    result.resumed = log.found();
    const core::ParamValues start = parameters_of(options.config, space);
    try {
        Tuner tuner(options, space, bench, log);
        result.defaults = {options.config.info->name, start, tuner.value_of(start), {}, {}};
        bench.start_from(result.defaults.found.by_view);
        search::search(tuner.into(result.steps), space.point_of(start), options.plan);
        if (options.random) {
            search::random_search(tuner.into(result.random_steps), space.size(), options.plan);
        }
    } catch (const Interrupted&) {
        result.is_interrupted = true;
        return result;
    }
    const TuneStep& best = best_of(result.steps);
    // The start of the search is the default taken into the ranges, which need not be the default.
    const bool is_better = best.found.value < result.defaults.found.value;
    result.tuned = result.defaults;
    if (is_better) {
        result.tuned.settings = best.settings;
        result.tuned.found = best.found;
    }
    result.tuned.name = options.name;
    if (options.random && !result.random_steps.empty()) {
        const TuneStep& lucky = best_of(result.random_steps);
        result.random = TunedSettings{"random search", lucky.settings, lucky.found, {}, {}};
    }
    if (heldout.empty() || is_by_kind(options.objective))
        result.left_out = leave_one_out(result.steps, bench.tune_views(), options.objective);
    std::vector<TunedSettings*> all = {&result.defaults, &result.tuned};
    if (result.random) all.push_back(&*result.random);
    for (TunedSettings* each : all)
        each->train = bench.counts(with(options.config, each->settings));
    const bool has_planes =
        std::ranges::any_of(result.steps, [](auto& step) { return step.found.is_by_planes; });
    if (has_planes) result.agreement = bench.agreement(with(options.config, result.tuned.settings));
    if (!heldout.empty()) {
        TuneBench unseen(heldout, options.trace, options.threads);
        result.is_interrupted = core::is_interrupted();
        if (result.is_interrupted) return result;
        result.heldout_views = unseen.view_count();
        for (TunedSettings* each : all)
            each->heldout = unseen.counts(with(options.config, each->settings));
    }
    write_results(options, space, result);
    log.remove();
    return result;
}

}  // namespace ink::tune
