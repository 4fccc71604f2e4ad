#include "report/figure_views.h"

#include <fmt/format.h>

#include <memory>

#include "core/parallel.h"
#include "core/progress.h"
#include "harness/interrupt.h"

namespace ink::report {
namespace {

using Prepared = std::vector<std::unique_ptr<harness::PreparedMethod>>;

void fill_place(const harness::Subject& subject,
                const scene::View& view,
                const FigureDrawing& drawing,
                harness::Row& row) {
    row.scene = subject.scene.name;
    row.view = view.camera.name;
    row.split = subject.scene.split == scene::Split::train ? "train" : "heldout";
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = drawing.measure.threads;
    row.seed = drawing.seed;
    row.weld_epsilon = drawing.trace.truth.weld_epsilon;
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(subject.scene));
}

/// The methods' shots (brackets come after them) as figures need them.
FigureView figure_view(harness::ViewTruth truth,
                       std::vector<harness::Shot> shots,
                       Prepared& methods) {
    FigureView view{shots.front().row.scene, shots.front().row.view, std::move(truth), {}};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (shots[i].row.is_ok()) view.shots.push_back({shots[i].row, {}, {}});
    }
    std::vector<const harness::Shot*> good;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (shots[i].row.is_ok()) good.push_back(&shots[i]);
    }
    core::parallel_for(good.size(), core::hardware_threads(), [&](std::size_t i) {
        view.shots[i].marks = draw::mark_errors(
            view.truth.traced.labels,
            good[i]->picture,
            {.threshold = good[i]->threshold, .wrong = good[i]->scored.attribution.pixels});
    });
    return view;
}

void add_layers(const scene::View& view,
                const FigureDrawing& drawing,
                Prepared& methods,
                FigureView& shown) {
    for (const auto& method : methods) {
        for (FigureShot& shot : shown.shots) {
            if (shot.row.method != method->entrant().info->name) continue;
            shot.layers =
                method->method().layers({view, drawing.measure.threads, drawing.measure.skips});
        }
    }
}

/// One subject's views on their way into the result.
class SceneDrawing {
  public:
    SceneDrawing(const harness::Subject& subject, const FigureDrawing& drawing)
        : subject_(subject),
          drawing_(drawing),
          model_(subject.scene, drawing.trace.truth),
          predictor_(subject.scene) {
        for (const harness::Entrant& entrant : drawing.entrants)
            methods_.push_back(std::make_unique<harness::PreparedMethod>(entrant, subject.scene));
    }

    void draw(const scene::View& view, DrawnScenes& drawn) {
        std::vector<harness::Shot> shots = harness::method_shots(methods_, view, drawing_.measure);
        harness::ViewTruth truth;
        try {
            truth = harness::trace_view(model_, view, drawing_.trace.cache);
            std::vector<harness::Shot> brackets = harness::bracket_shots(truth);
            std::move(brackets.begin(), brackets.end(), std::back_inserter(shots));
        } catch (const truth::TooLarge& reason) {
            for (harness::Shot& shot : shots)
                shot.row.status = fmt::format("too_large: {}", reason.what());
        }
        for (harness::Shot& shot : shots)
            fill_place(subject_, view, drawing_, shot.row);
        const bool has_truth = !truth.traced.labels.is_empty();
        if (has_truth) {
            harness::score_shots(truth, shots);
            harness::attribute_shots(truth, view, predictor_, shots);
        }
        for (const harness::Shot& shot : shots)
            drawn.rows.push_back(shot.row);
        if (!has_truth || &view != &subject_.views.front()) return;
        drawn.shown.push_back(figure_view(std::move(truth), std::move(shots), methods_));
        add_layers(view, drawing_, methods_, drawn.shown.back());
    }

  private:
    const harness::Subject& subject_;
    const FigureDrawing& drawing_;
    truth::SceneModel model_;
    harness::MissPredictor predictor_;
    Prepared methods_;
};

}  // namespace

DrawnScenes draw_scenes(const std::vector<harness::Subject>& subjects,
                        const FigureDrawing& drawing) {
    const harness::InterruptGuard guard;
    int total = 0;
    for (const harness::Subject& subject : subjects)
        total += static_cast<int>(subject.views.size());
    core::Progress progress("figures", total);
    DrawnScenes drawn;
    int done = 0;
    for (const harness::Subject& subject : subjects) {
        if (harness::is_interrupted()) break;
        SceneDrawing scene(subject, drawing);
        for (const scene::View& view : subject.views) {
            if (harness::is_interrupted()) break;
            progress.report(done++, fmt::format("{} {}", subject.scene.name, view.camera.name));
            scene.draw(view, drawn);
        }
    }
    drawn.is_interrupted = harness::is_interrupted();
    return drawn;
}

}  // namespace ink::report
