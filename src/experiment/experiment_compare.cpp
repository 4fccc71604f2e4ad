#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "core/parallel.h"
#include "experiment/cost_facts.h"
#include "experiment/experiment_plan.h"
#include "harness/bins.h"
#include "harness/csv.h"
#include "harness/suite.h"
#include "harness/sweep.h"
#include "harness/view_cells.h"
#include "linear_code/cancellation_study.h"

namespace ink::experiment {
namespace {

/// Settings of one method that take turns; more at once would not fit into memory on large models.
constexpr std::size_t kSettingsAtOnce = 48;
constexpr int kBrackets = 3;

std::string heading_of(const std::vector<std::string>& columns) {
    return fmt::format("{}", fmt::join(columns, ","));
}

/// The scenes of a plan, and what is kept of the one that is being worked on from block to block.
class Bench {
  public:
    Bench(const Experiment& experiment, harness::TraceOptions trace)
        : experiment_(experiment), trace_(std::move(trace)), entrants_(entrants_of(experiment)) {
        trace_.witness = experiment.witness;
        trace_.truth.threads = core::hardware_threads();
        for (const PictureSize& size : experiment.sizes) {
            harness::ViewRequest request;
            request.width_px = size.width_px;
            request.height_px = size.height_px;
            std::vector<harness::Subject> subjects =
                harness::load_subjects(experiment.scenes, request);
            for (std::size_t s = 0; s < subjects.size(); ++s) {
                views_[{s, size.width_px, size.height_px}] = std::move(subjects[s].views);
                if (scenes_.size() == s) scenes_.push_back(std::move(subjects[s].scene));
            }
        }
    }

    [[nodiscard]] const Experiment& experiment() const { return experiment_; }
    [[nodiscard]] const std::vector<harness::Entrant>& entrants() const { return entrants_; }
    [[nodiscard]] const std::vector<scene::Scene>& scenes() const { return scenes_; }
    [[nodiscard]] std::size_t view_count(std::size_t scene, const PictureSize& size) const {
        const std::size_t all = views_.at({scene, size.width_px, size.height_px}).size();
        return experiment_.views > 0 ? std::min(all, static_cast<std::size_t>(experiment_.views))
                                     : all;
    }
    [[nodiscard]] const scene::View& view(std::size_t scene,
                                          const PictureSize& size,
                                          std::size_t n) const {
        return views_.at({scene, size.width_px, size.height_px})[n];
    }

    [[nodiscard]] harness::CellOptions cell_options(int threads) const {
        harness::CellOptions options{{}, trace_, experiment_.seed};
        options.measure.threads = threads;
        options.measure.max_repetitions = experiment_.repetitions;
        options.measure.min_repetitions =
            std::min(options.measure.min_repetitions, experiment_.repetitions);
        options.measure.budget_s = experiment_.budget_s;
        return options;
    }

    /// The truth of a view; that of the last view asked for is at hand.
    const harness::TracedView& traced(std::size_t scene, const scene::View& view) {
        turn_to(scene);
        if (traced_view_ != &view) {
            traced_ = harness::trace_with_facts(*model_, scenes_[scene], view, trace_);
            traced_view_ = &view;
        }
        return traced_;
    }

    harness::MissPredictor& predictor(std::size_t scene) {
        turn_to(scene);
        return *predictor_;
    }

    /// All methods at their own settings, ready for the scene.
    std::vector<std::unique_ptr<harness::PreparedMethod>>& methods(std::size_t scene) {
        turn_to(scene);
        if (methods_.empty()) methods_ = prepared(entrants_, scene);
        return methods_;
    }

    [[nodiscard]] std::vector<std::unique_ptr<harness::PreparedMethod>> prepared(
        const std::vector<harness::Entrant>& entrants, std::size_t scene) const {
        std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
        for (const harness::Entrant& entrant : entrants)
            methods.push_back(std::make_unique<harness::PreparedMethod>(entrant, scenes_[scene]));
        return methods;
    }

  private:
    void turn_to(std::size_t scene) {
        if (model_ && scene_ == scene) return;
        scene_ = scene;
        methods_.clear();
        traced_view_ = nullptr;
        model_ = std::make_unique<truth::SceneModel>(scenes_[scene], trace_.truth);
        predictor_ = std::make_unique<harness::MissPredictor>(scenes_[scene]);
    }

    Experiment experiment_;
    harness::TraceOptions trace_;
    std::vector<harness::Entrant> entrants_;
    std::vector<scene::Scene> scenes_;
    std::map<std::tuple<std::size_t, int, int>, std::vector<scene::View>> views_;
    std::size_t scene_ = 0;
    std::unique_ptr<truth::SceneModel> model_;
    std::unique_ptr<harness::MissPredictor> predictor_;
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods_;
    const scene::View* traced_view_ = nullptr;
    harness::TracedView traced_;
};

/// Where a block's cells are.
struct BlockPlace {
    std::size_t scene = 0;
    const scene::View* view = nullptr;
    int threads = 1;
};

std::string place_text(const Bench& bench, const BlockPlace& at) {
    return fmt::format("{} {} {}x{} threads {}",
                       bench.scenes()[at.scene].name,
                       at.view->camera.name,
                       at.view->width_px,
                       at.view->height_px,
                       at.threads);
}

void add_line(const std::string& line, const std::string& table, BlockResult& result) {
    if (!line.empty()) result.lines[table] += line + "\n";
}

void add_row(const harness::Row& row, const std::string& table, BlockResult& result) {
    add_line(to_csv(row), table, result);
    result.lines[facts_table(table)] += cost_facts_line(row) + "\n";
}

/// The methods at their own settings, and the brackets: rows.csv and what stands beside it.
BlockResult run_methods(Bench& bench, const BlockPlace& at) {
    const scene::Scene& scene = bench.scenes()[at.scene];
    const harness::CellOptions options = bench.cell_options(at.threads);
    std::vector<harness::Shot> shots =
        harness::method_shots(bench.methods(at.scene), *at.view, options.measure);
    const harness::TracedView& traced = bench.traced(at.scene, *at.view);
    BlockResult result;
    if (bench.experiment().full_scores) {
        harness::finish_shots(scene, *at.view, traced, options, shots);
        if (traced.has_truth()) {
            harness::MissPredictor& predictor = bench.predictor(at.scene);
            harness::attribute_shots(traced.truth, *at.view, predictor, shots);
            for (const linear_code::CancellationRow& row :
                 linear_code::study_cancellation(traced.truth, *at.view, predictor, shots))
                add_line(linear_code::cancellation_csv(row), "cancellation.csv", result);
        }
    } else {
        harness::finish_briefly(scene, *at.view, traced, options, shots);
    }
    harness::check_brackets(shots, result.faults);
    for (const harness::Shot& shot : shots) {
        add_row(shot.row, "rows.csv", result);
        if (!shot.row.is_ok() || !shot.row.lines) continue;
        add_line(harness::curve_csv(shot.row, shot.scored.curve), "curves.csv", result);
        add_line(harness::ladder_csv(shot.row), "ladder.csv", result);
        add_line(harness::bin_csv(shot.row, shot.row.lines->bins), "bins.csv", result);
    }
    return result;
}

/// Settings of one method: rows of sweep.csv, without brackets.
BlockResult run_settings(Bench& bench,
                         const BlockPlace& at,
                         const std::vector<harness::Entrant>& settings) {
    harness::CellOptions options = bench.cell_options(at.threads);
    // As compare's own sweeps have it: times to a few percent do, and there are many settings.
    const harness::MeasureOptions brief = harness::SweepOptions{}.measure;
    options.measure.min_repetitions = brief.min_repetitions;
    options.measure.max_repetitions =
        std::min(brief.max_repetitions, options.measure.max_repetitions);
    options.measure.budget_s = brief.budget_s;
    auto methods = bench.prepared(settings, at.scene);
    std::vector<harness::Shot> shots = harness::method_shots(methods, *at.view, options.measure);
    const harness::TracedView& traced = bench.traced(at.scene, *at.view);
    harness::finish_briefly(bench.scenes()[at.scene], *at.view, traced, options, shots);
    BlockResult result;
    for (std::size_t i = 0; i < settings.size(); ++i)
        add_row(shots[i].row, "sweep.csv", result);
    return result;
}

/// Seconds for `cells` pictures of a view, roughly, on two cores without other work: a part for
/// every cell, one for its pixels (scores) and one for its triangles (drawing); then the truth.
double work_s(const Bench& bench, const BlockPlace& at, int cells, bool is_full) {
    const double mpx = 1e-6 * at.view->width_px * at.view->height_px;
    const auto triangles = static_cast<double>(scene::triangle_count(bench.scenes()[at.scene]));
    const double draws = is_full ? bench.experiment().repetitions : 4;
    const double draw_s = std::min(draws * (0.006 * mpx + 4e-8 * triangles),
                                   is_full ? bench.experiment().budget_s : 0.03);
    const double score_s = (is_full && bench.experiment().full_scores ? 0.12 : 0.02) * mpx;
    return cells * (0.002 + draw_s + score_s) + (is_full ? 0.05 + 0.2 * mpx : 0.01);
}

/// The blocks of one method's settings on a place, so many at once.
void plan_settings(const std::shared_ptr<Bench>& bench,
                   const BlockPlace& at,
                   const std::vector<harness::Entrant>& settings,
                   Plan& plan) {
    for (std::size_t begin = 0; begin < settings.size(); begin += kSettingsAtOnce) {
        const std::size_t end = std::min(settings.size(), begin + kSettingsAtOnce);
        const std::vector<harness::Entrant> part(
            settings.begin() + static_cast<std::ptrdiff_t>(begin),
            settings.begin() + static_cast<std::ptrdiff_t>(end));
        const int cells = static_cast<int>(part.size());
        plan.blocks.push_back({fmt::format("{} sweep {} settings {}..{}",
                                           place_text(*bench, at),
                                           part.front().info->name,
                                           begin + 1,
                                           end),
                               cells,
                               work_s(*bench, at, cells, false),
                               false,
                               [bench, at, part] { return run_settings(*bench, at, part); }});
    }
}

/// All settings over which a method is swept on the n-th view: its grids', then its own.
std::vector<harness::Entrant> settings_of(const Bench& bench,
                                          const harness::Entrant& entrant,
                                          std::size_t nth_view) {
    std::vector<harness::Entrant> settings;
    const auto append = [&settings](std::vector<harness::Entrant> more) {
        std::move(more.begin(), more.end(), std::back_inserter(settings));
    };
    for (const SettingGrid& grid : bench.experiment().grids)
        if (grid.method == entrant.info->name) append(grid_entrants(entrant, grid));
    const auto own_views = static_cast<std::size_t>(bench.experiment().own_sweep_views);
    if (nth_view < own_views) append(harness::sweep_entrants(entrant));
    std::set<core::ParamValues> known;
    std::erase_if(settings, [&](const harness::Entrant& made) {
        return !known.insert(made.info->complete(made.settings)).second;
    });
    return settings;
}

}  // namespace

void plan_compare(const Experiment& experiment, const harness::TraceOptions& trace, Plan& plan) {
    const auto bench = std::make_shared<Bench>(experiment, trace);
    plan.tables.push_back({"rows.csv", heading_of(harness::row_columns())});
    if (experiment.full_scores) {
        plan.tables.push_back({"curves.csv", heading_of(harness::curve_columns())});
        plan.tables.push_back({"bins.csv", heading_of(harness::bin_columns())});
        plan.tables.push_back({"ladder.csv", heading_of(harness::ladder_columns())});
        plan.tables.push_back(
            {"cancellation.csv", heading_of(linear_code::cancellation_columns())});
    }
    if (!experiment.grids.empty() || experiment.own_sweep_views > 0) {
        plan.tables.push_back({"sweep.csv", heading_of(harness::row_columns())});
    }
    const int cells = static_cast<int>(bench->entrants().size()) + kBrackets;
    for (std::size_t s = 0; s < bench->scenes().size(); ++s) {
        for (const PictureSize& size : experiment.sizes) {
            for (std::size_t v = 0; v < bench->view_count(s, size); ++v) {
                for (const int threads : experiment.threads) {
                    const BlockPlace at{s, &bench->view(s, size, v), threads};
                    plan.blocks.push_back({place_text(*bench, at),
                                           cells,
                                           work_s(*bench, at, cells, true),
                                           false,
                                           [bench, at] { return run_methods(*bench, at); }});
                    for (const harness::Entrant& entrant : bench->entrants())
                        plan_settings(bench, at, settings_of(*bench, entrant, v), plan);
                }
            }
        }
    }
}

}  // namespace ink::experiment
