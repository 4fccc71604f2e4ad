#include "report/figure_views.h"

#include <fmt/format.h>

#include <memory>

#include "core/parallel.h"
#include "core/progress.h"
#include "harness/interrupt.h"

namespace ink::report {
namespace {

using Prepared = std::vector<std::unique_ptr<harness::PreparedMethod>>;

void fill_place(const harness::SceneViews& scene_views,
                const scene::View& view,
                const FigureDrawing& drawing,
                harness::Row& row) {
    row.scene = scene_views.scene.name;
    row.view = view.camera.name;
    row.split = scene_views.scene.split == scene::Split::train ? "train" : "heldout";
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = drawing.measure.threads;
    row.seed = drawing.seed;
    row.weld_epsilon = drawing.trace.truth.weld_epsilon;
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(scene_views.scene));
}

/// The methods' evaluations (baselines come after them) as figures need them.
FigureView figure_view(harness::ViewTruth truth,
                       std::vector<harness::Evaluation> evaluations,
                       Prepared& methods) {
    FigureView view{
        evaluations.front().row.scene, evaluations.front().row.view, std::move(truth), {}};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (evaluations[i].row.is_ok()) view.evaluations.push_back({evaluations[i].row, {}, {}});
    }
    std::vector<const harness::Evaluation*> good;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (evaluations[i].row.is_ok()) good.push_back(&evaluations[i]);
    }
    core::parallel_for(good.size(), core::hardware_threads(), [&](std::size_t i) {
        view.evaluations[i].marks = draw::mark_errors(
            view.truth.traced.labels,
            good[i]->image,
            {.threshold = good[i]->threshold, .wrong = good[i]->scored.attribution.pixels});
    });
    return view;
}

void add_layers(const scene::View& view,
                const FigureDrawing& drawing,
                Prepared& methods,
                FigureView& shown) {
    for (const auto& method : methods) {
        for (FigureEvaluation& evaluation : shown.evaluations) {
            if (evaluation.row.method != method->config().info->name) continue;
            evaluation.layers =
                method->method().layers({view, drawing.measure.threads, drawing.measure.skips});
        }
    }
}

/// One scene's views on their way into the result.
class SceneDrawing {
  public:
    SceneDrawing(const harness::SceneViews& scene_views, const FigureDrawing& drawing)
        : scene_views_(scene_views),
          drawing_(drawing),
          model_(scene_views.scene, drawing.trace.truth),
          predictor_(scene_views.scene) {
        for (const harness::MethodConfig& config : drawing.configs)
            methods_.push_back(
                std::make_unique<harness::PreparedMethod>(config, scene_views.scene));
    }

    void draw(const scene::View& view, DrawnScenes& drawn) {
        std::vector<harness::Evaluation> evaluations =
            harness::method_evaluations(methods_, view, drawing_.measure);
        harness::ViewTruth truth;
        try {
            truth = harness::trace_view(model_, view, drawing_.trace.cache);
            std::vector<harness::Evaluation> baselines = harness::baseline_evaluations(truth);
            std::move(baselines.begin(), baselines.end(), std::back_inserter(evaluations));
        } catch (const truth::TooLarge& reason) {
            for (harness::Evaluation& evaluation : evaluations)
                evaluation.row.status = fmt::format("too_large: {}", reason.what());
        }
        for (harness::Evaluation& evaluation : evaluations)
            fill_place(scene_views_, view, drawing_, evaluation.row);
        const bool has_truth = !truth.traced.labels.is_empty();
        if (has_truth) {
            harness::score_evaluations(truth, evaluations);
            harness::attribute_evaluations(truth, view, predictor_, evaluations);
        }
        for (const harness::Evaluation& evaluation : evaluations)
            drawn.rows.push_back(evaluation.row);
        if (!has_truth || &view != &scene_views_.views.front()) return;
        drawn.shown.push_back(figure_view(std::move(truth), std::move(evaluations), methods_));
        add_layers(view, drawing_, methods_, drawn.shown.back());
    }

  private:
    const harness::SceneViews& scene_views_;
    const FigureDrawing& drawing_;
    truth::SceneModel model_;
    harness::MissPredictor predictor_;
    Prepared methods_;
};

}  // namespace

DrawnScenes draw_scenes(const std::vector<harness::SceneViews>& scenes,
                        const FigureDrawing& drawing) {
    const harness::InterruptGuard guard;
    int total = 0;
    for (const harness::SceneViews& scene_views : scenes)
        total += static_cast<int>(scene_views.views.size());
    core::Progress progress("figures", total);
    DrawnScenes drawn;
    int done = 0;
    for (const harness::SceneViews& scene_views : scenes) {
        if (harness::is_interrupted()) break;
        SceneDrawing scene(scene_views, drawing);
        for (const scene::View& view : scene_views.views) {
            if (harness::is_interrupted()) break;
            progress.report(done++, fmt::format("{} {}", scene_views.scene.name, view.camera.name));
            scene.draw(view, drawn);
        }
    }
    drawn.is_interrupted = harness::is_interrupted();
    return drawn;
}

}  // namespace ink::report
