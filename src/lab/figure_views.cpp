#include "lab/figure_views.h"

#include <fmt/format.h>

#include <memory>

#include "core/parallel.h"
#include "core/progress.h"
#include "lab/interrupt.h"

namespace ink::lab {
namespace {

using Prepared = std::vector<std::unique_ptr<PreparedMethod>>;

void fill_place(const Subject& subject,
                const scene::View& view,
                const FigureDrawing& drawing,
                Row& row) {
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
FigureView figure_view(ViewTruth truth, std::vector<Shot> shots, Prepared& methods) {
    FigureView view{shots.front().row.scene, shots.front().row.view, std::move(truth), {}};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (shots[i].row.is_ok()) view.shots.push_back({shots[i].row, {}, {}});
    }
    std::vector<const Shot*> good;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (shots[i].row.is_ok()) good.push_back(&shots[i]);
    }
    core::parallel_for(good.size(), core::hardware_threads(), [&](std::size_t i) {
        view.shots[i].marks = mark_errors(
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
    SceneDrawing(const Subject& subject, const FigureDrawing& drawing)
        : subject_(subject),
          drawing_(drawing),
          model_(subject.scene, drawing.trace.truth),
          predictor_(subject.scene) {
        for (const Entrant& entrant : drawing.entrants)
            methods_.push_back(std::make_unique<PreparedMethod>(entrant, subject.scene));
    }

    void draw(const scene::View& view, DrawnScenes& drawn) {
        std::vector<Shot> shots = method_shots(methods_, view, drawing_.measure);
        ViewTruth truth;
        try {
            truth = trace_view(model_, view, drawing_.trace.cache);
            std::vector<Shot> brackets = bracket_shots(truth);
            std::move(brackets.begin(), brackets.end(), std::back_inserter(shots));
        } catch (const truth::TooLarge& reason) {
            for (Shot& shot : shots)
                shot.row.status = fmt::format("too_large: {}", reason.what());
        }
        for (Shot& shot : shots)
            fill_place(subject_, view, drawing_, shot.row);
        const bool has_truth = !truth.traced.labels.is_empty();
        if (has_truth) {
            score_shots(truth, shots);
            attribute_shots(truth, view, predictor_, shots);
        }
        for (const Shot& shot : shots)
            drawn.rows.push_back(shot.row);
        if (!has_truth || &view != &subject_.views.front()) return;
        drawn.shown.push_back(figure_view(std::move(truth), std::move(shots), methods_));
        add_layers(view, drawing_, methods_, drawn.shown.back());
    }

  private:
    const Subject& subject_;
    const FigureDrawing& drawing_;
    truth::SceneModel model_;
    MissPredictor predictor_;
    Prepared methods_;
};

}  // namespace

DrawnScenes draw_scenes(const std::vector<Subject>& subjects, const FigureDrawing& drawing) {
    const InterruptGuard guard;
    int total = 0;
    for (const Subject& subject : subjects)
        total += static_cast<int>(subject.views.size());
    core::Progress progress("figures", total);
    DrawnScenes drawn;
    int done = 0;
    for (const Subject& subject : subjects) {
        if (is_interrupted()) break;
        SceneDrawing scene(subject, drawing);
        for (const scene::View& view : subject.views) {
            if (is_interrupted()) break;
            progress.report(done++, fmt::format("{} {}", subject.scene.name, view.camera.name));
            scene.draw(view, drawn);
        }
    }
    drawn.is_interrupted = is_interrupted();
    return drawn;
}

}  // namespace ink::lab
