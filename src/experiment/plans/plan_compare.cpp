#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "experiment/experiment_plan.h"
#include "experiment/view_bench.h"
#include "harness/cells/sweep.h"
#include "harness/images/view_images.h"
#include "harness/rows/side_tables.h"
#include "linear_code/cancellation.h"

namespace ink::experiment {
namespace {

/// Where a block's cells are.
struct BlockPlace {
    std::size_t scene = 0;
    const scene::View* view = nullptr;
    int threads = 1;
    std::int64_t first_cell = 0;  ///< the number of the first method's row
    bool is_first_view = false;   ///< of its scene: methods are made ready there
    bool keeps_images = false;
    /// Per method: its own settings are the first of its sweep here.
    std::vector<bool> sweeps_own = {};
};

/// Some settings of the n-th method.
struct SettingsPart {
    std::size_t method = 0;
    std::size_t first = 0;  ///< the number of the first setting, from 1
    std::vector<method::MethodConfig> settings;
};

void add_side_tables(std::int64_t cell,
                     const harness::Evaluation& evaluation,
                     BlockResult& result) {
    if (!evaluation.row.is_ok() || evaluation.row.tolerance_sweep.empty()) return;
    result.lines["curves.csv"] += harness::curve_lines(cell, evaluation.scored.curve);
    result.lines["tolerances.csv"] +=
        harness::tolerance_lines(cell, evaluation.row.tolerance_sweep);
    result.lines["bins.csv"] += harness::bin_lines(cell, evaluation.row.bins);
}

/// The layers of what was drawn, where they are kept.
using Layers = std::vector<harness::MethodLayers>;

/// What `count` methods draw of a view, as many at a time as fit into memory; `ready` is
/// harness::ViewDrawings::ready.
template <class Ready>
std::vector<harness::Evaluation> draw(ViewBench& bench,
                                      const BlockPlace& at,
                                      std::size_t count,
                                      Ready ready,
                                      const harness::MeasureOptions& measure,
                                      Layers* layers = nullptr) {
    harness::ViewDrawings drawings{*at.view, count, bench.most_at_once(at.scene)};
    drawings.ready = ready;
    if (layers != nullptr) {
        drawings.see = [&](std::size_t, harness::PreparedMethod& method, const auto& drawn) {
            if (!drawn.row.is_ok()) return;
            layers->push_back(
                harness::buffer_layers(method, {*at.view, measure.threads, measure.skips}));
        };
    }
    return harness::draw_view(drawings, measure);
}

/// Why the scored evaluations are wrong where they are, and what codes had to miss.
void explain(ViewBench& bench,
             const BlockPlace& at,
             const harness::ViewTruth& truth,
             std::vector<harness::Evaluation>& evaluations,
             BlockResult& result) {
    harness::MissPredictor& predictor = bench.predictor(at.scene);
    harness::attribute_evaluations(truth, *at.view, predictor, evaluations);
    for (const linear_code::CancellationRow& row :
         linear_code::study_cancellation(truth, *at.view, predictor, evaluations)) {
        result.lines["cancellation.csv"] += linear_code::cancellation_table().line(
            at.first_cell + static_cast<std::int64_t>(row.evaluation), row);
    }
}

/// The methods at their own settings, and the baselines: rows.csv and what stands beside it, and
/// the lines of sweep.csv that say the same. `swept` are its parameters' columns.
BlockResult run_methods(ViewBench& bench,
                        const BlockPlace& at,
                        const harness::SweepColumns& swept) {
    const scene::Scene& scene = bench.scenes()[at.scene];
    const bool is_full = bench.experiment().compare.full_scores;
    harness::CellOptions options = bench.cell_options(at.threads);
    options.scores = is_full ? harness::Scores::full : harness::Scores::brief;
    BlockResult result;
    const std::shared_ptr<const harness::TracedView> held = bench.traced(at.scene, *at.view);
    const harness::TracedView& traced = *held;
    const bool keeps_images = at.keeps_images && traced.has_truth();
    Layers layers;
    // The same methods come again with the next view.
    const auto ready = [&](std::size_t first, std::size_t) {
        return bench.methods(at.scene, first);
    };
    std::vector<harness::Evaluation> evaluations;
    {
        const auto methods = bench.hold_methods(at.scene);
        evaluations = draw(bench,
                           at,
                           bench.configs().size(),
                           ready,
                           options.measure,
                           keeps_images ? &layers : nullptr);
    }
    harness::finish_evaluations(scene, *at.view, traced, options, evaluations);
    if (is_full && traced.has_truth()) explain(bench, at, traced.truth, evaluations, result);
    harness::check_baselines(evaluations, result.faults);
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        harness::Evaluation& evaluation = evaluations[i];
        const std::int64_t cell = at.first_cell + static_cast<std::int64_t>(i);
        if (!bench.experiment().times) clear_times(evaluation.row);
        result.lines["rows.csv"] +=
            harness::row_line(cell, harness::Study::compare, evaluation.row);
        result.lines["cost.csv"] += harness::cost_line(cell, evaluation.row);
        add_side_tables(cell, evaluation, result);
        if (i < at.sweeps_own.size() && at.sweeps_own[i])
            result.lines["sweep.csv"] += harness::sweep_line(cell, 1, swept, evaluation.row);
    }
    if (keeps_images) result.files = harness::image_files(traced.truth, scene, evaluations, layers);
    return result;
}

/// Other settings of one method: lines of sweep.csv, without baselines.
BlockResult run_settings(ViewBench& bench,
                         const BlockPlace& at,
                         const SettingsPart& part,
                         const harness::SweepColumns& swept) {
    harness::CellOptions options = bench.cell_options(at.threads);
    options.measure = harness::sweep_measure(options.measure, bench.scenes().size());
    options.scores = harness::Scores::settings;
    BlockResult result;
    const harness::SharedDrawings drawings(part.settings);
    const auto ready = [&](std::size_t first, std::size_t end) {
        return bench.prepared(std::span(drawings.drawn()).subspan(first, end - first), at.scene);
    };
    std::vector<harness::Evaluation> evaluations =
        drawings.shared(draw(bench, at, drawings.drawn().size(), ready, options.measure));
    harness::finish_evaluations(bench.scenes()[at.scene],
                                *at.view,
                                *bench.traced(at.scene, *at.view),
                                options,
                                evaluations);
    const std::int64_t cell = at.first_cell + static_cast<std::int64_t>(part.method);
    for (std::size_t i = 0; i < part.settings.size(); ++i) {
        if (!bench.experiment().times) clear_times(evaluations[i].row);
        result.lines["sweep.csv"] +=
            harness::sweep_line(cell, static_cast<int>(part.first + i), swept, evaluations[i].row);
    }
    return result;
}

/// Settings of one method that take turns; more at once would not fit into memory on large models.
constexpr std::size_t kSettingsAtOnce = 48;
/// The motion study beside a comparison: small images, a few pixels' way.
constexpr ImageSize kMotionSize{640, 360};
constexpr int kMotionFrames = 24;

/// In the mean of all methods over the catalogue, of one lane.
constexpr double kPrepare_s_per_triangle = 2.5e-7;
constexpr double kTruth_s_per_triangle = 2.5e-6;

std::string place_text(const ViewBench& bench, const BlockPlace& at) {
    return fmt::format("{} {} {}x{} threads {}",
                       bench.scenes()[at.scene].name,
                       at.view->camera.name,
                       at.view->width_px,
                       at.view->height_px,
                       at.threads);
}

/// What a block has to do.
struct DrawnCells {
    int cells = 0;
    int prepared = 0;      ///< methods that are made ready for it, or settings that are drawn
    bool is_full = false;  ///< methods with baselines; else settings, scored briefly
};

/// Samples that a method draws of a pixel, in the mean.
double mean_samples(const Experiment& experiment) {
    double sum = 0;
    for (const methods::Antialias antialias : experiment.antialias)
        sum += std::pow(methods::samples_per_side(antialias), 2);
    return sum / static_cast<double>(experiment.antialias.size());
}

/// Seconds for a block of a view, roughly, on two cores without other work: a part for every cell,
/// one for its pixels (scores, images) and one for its triangles (drawing), one for what is made
/// ready, and the truth.
double work_s(const ViewBench& bench, const BlockPlace& at, const DrawnCells& work) {
    const Experiment& experiment = bench.experiment();
    const double mpx = 1e-6 * at.view->width_px * at.view->height_px;
    const auto triangles = static_cast<double>(scene::triangle_count(bench.scenes()[at.scene]));
    constexpr double kUsualDraws = 12;  // from which a time is known on an idle machine
    const bool is_timed = experiment.times && work.is_full;
    const double draws = is_timed ? std::min<double>(kUsualDraws, experiment.repetitions) : 2;
    const double draw_mpx = mpx * mean_samples(experiment);
    const double all_s = draws * (0.0025 * draw_mpx + 2e-8 * triangles);
    const double draw_s = work.is_full ? all_s : std::min(all_s, 0.03);
    const int drawn = work.is_full ? work.cells - harness::kBaselines : work.prepared;
    const double image_s = at.keeps_images ? 0.011 * mpx : 0;
    const double score_s = (work.is_full && experiment.compare.full_scores ? 0.018 : 0.002) * mpx;
    const double truth_s =
        work.is_full ? 0.1 + 0.2 * mpx + kTruth_s_per_triangle * triangles : 0.003;
    return kShareOfTwoLanes * (work.cells * (0.001 + score_s + image_s) + drawn * draw_s +
                               work.prepared * kPrepare_s_per_triangle * triangles + truth_s);
}

/// All settings over which a method is swept on the n-th view: its grids', then its own.
std::vector<method::MethodConfig> settings_of(const ViewBench& bench,
                                              const method::MethodConfig& config,
                                              std::size_t nth_view) {
    std::vector<method::MethodConfig> settings;
    const auto append = [&settings](std::vector<method::MethodConfig> more) {
        std::move(more.begin(), more.end(), std::back_inserter(settings));
    };
    for (const SettingGrid& grid : bench.experiment().compare.grids)
        if (grid.method == config.info->name) append(grid_configs(config, grid));
    const auto own_views = static_cast<std::size_t>(bench.experiment().compare.own_sweep_views);
    if (nth_view < own_views) append(harness::sweep_configs(config));
    std::set<core::ParamValues> known;
    std::erase_if(settings, [&](const method::MethodConfig& made) {
        return !known.insert(made.info->complete(made.settings)).second;
    });
    return settings;
}

/// The parameters in which any setting of any sweep differs from its method's own.
std::vector<std::string> parameters_swept(const ViewBench& bench) {
    std::set<std::string> names;
    for (const method::MethodConfig& config : bench.configs()) {
        const core::ParamValues own = config.info->complete(config.settings);
        for (const method::MethodConfig& setting : settings_of(bench, config, 0)) {
            for (const auto& [name, value] : setting.info->complete(setting.settings))
                if (own.at(name) != value) names.insert(name);
        }
    }
    return {names.begin(), names.end()};
}

/// Takes a method's own settings out of those over which it is swept; false if they are not there.
bool take_own(const method::MethodConfig& own, std::vector<method::MethodConfig>& settings) {
    const core::ParamValues values = own.info->complete(own.settings);
    return std::erase_if(settings, [&](const method::MethodConfig& setting) {
               return setting.info->complete(setting.settings) == values;
           }) > 0;
}

/// The blocks of one method's other settings on a place, so many at once, counted from `first`.
void plan_settings(const std::shared_ptr<ViewBench>& bench,
                   const BlockPlace& at,
                   std::size_t method,
                   std::size_t first,
                   const std::vector<method::MethodConfig>& settings,
                   const harness::SweepColumns& swept,
                   Plan& plan) {
    if (settings.empty()) return;
    const std::string& name = settings.front().info->name;
    const std::size_t most = std::min(kSettingsAtOnce, bench->most_at_once(at.scene));
    for (std::size_t begin = 0; begin < settings.size(); begin += most) {
        const std::size_t end = std::min(settings.size(), begin + most);
        SettingsPart part{method, first + begin, {}};
        part.settings.assign(settings.begin() + static_cast<std::ptrdiff_t>(begin),
                             settings.begin() + static_cast<std::ptrdiff_t>(end));
        const int cells = static_cast<int>(part.settings.size());
        const int drawn = static_cast<int>(harness::SharedDrawings(part.settings).drawn().size());
        plan.blocks.push_back(
            {fmt::format("{} sweep {} settings {}..{}",
                         place_text(*bench, at),
                         name,
                         first + begin,
                         first + end - 1),
             cells,
             work_s(*bench, at, {cells, drawn, false}),
             false,
             [bench, at, part, swept] { return run_settings(*bench, at, part, swept); },
             at.scene});
    }
}

void add_tables(const ViewBench& bench, const harness::SweepColumns& swept, Plan& plan) {
    plan.add_table(harness::rows_table());
    plan.add_table(harness::cost_table());
    if (bench.experiment().compare.full_scores) {
        plan.add_table(harness::curves_table());
        plan.add_table(harness::tolerances_table());
        plan.add_table(harness::bins_table());
        plan.add_table(linear_code::cancellation_table());
    }
    if (!swept.parameters.empty()) plan.add_table(harness::sweep_table(swept));
}

/// All blocks of one view: the methods, then the settings of each.
void plan_view(const std::shared_ptr<ViewBench>& bench,
               BlockPlace at,
               std::size_t nth_view,
               const harness::SweepColumns& swept,
               Plan& plan) {
    const int cells = static_cast<int>(bench->configs().size()) + harness::kBaselines;
    std::vector<std::vector<method::MethodConfig>> others;
    for (const method::MethodConfig& config : bench->configs()) {
        others.push_back(settings_of(*bench, config, nth_view));
        at.sweeps_own.push_back(take_own(config, others.back()));
    }
    at.first_cell = plan.take_cells(cells);
    plan.blocks.push_back({place_text(*bench, at),
                           cells,
                           work_s(*bench, at, {cells, at.is_first_view ? cells : 0, true}),
                           false,
                           [bench, at, swept] { return run_methods(*bench, at, swept); },
                           at.scene});
    for (std::size_t m = 0; m < others.size(); ++m)
        plan_settings(bench, at, m, at.sweeps_own[m] ? 2 : 1, others[m], swept, plan);
}

bool keeps_images(const Experiment& experiment, std::size_t nth_view, bool is_first_place) {
    if (!is_first_place || !experiment.compare.full_scores) return false;
    return experiment.compare.images == KeptImages::all ||
           (experiment.compare.images == KeptImages::first && nth_view == 0);
}

/// The motion study beside a comparison: all sequences, of a size of their own.
Experiment motion_beside(Experiment experiment) {
    experiment.scenes.clear();
    experiment.sizes = {kMotionSize};
    experiment.animation.frames = kMotionFrames;
    experiment.threads = {experiment.threads.front()};
    return experiment;
}

}  // namespace

void plan_compare(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const auto bench = std::make_shared<ViewBench>(experiment, trace);
    const harness::SweepColumns swept{.parameters = parameters_swept(*bench),
                                      .has_ink = scored_width_px(bench->experiment()).has_value()};
    add_tables(*bench, swept, plan);
    for (const scene::Scene& scene : bench->scenes())
        plan.add_model(scene);
    plan.release = [bench](std::size_t scene) { bench->release(scene); };
    plan.timed_threads = *std::max_element(experiment.threads.begin(), experiment.threads.end());
    for (std::size_t s = 0; s < bench->scenes().size(); ++s) {
        for (std::size_t z = 0; z < experiment.sizes.size(); ++z) {
            for (std::size_t v = 0; v < bench->view_count(s, experiment.sizes[z]); ++v) {
                for (std::size_t t = 0; t < experiment.threads.size(); ++t) {
                    const BlockPlace at{s,
                                        &bench->view(s, experiment.sizes[z], v),
                                        experiment.threads[t],
                                        0,
                                        v == 0,
                                        keeps_images(experiment, v, z == 0 && t == 0)};
                    plan_view(bench, at, v, swept, plan);
                }
            }
        }
    }
    if (experiment.compare.study_motion) plan_animation(motion_beside(experiment), trace, plan);
}

}  // namespace ink::experiment
