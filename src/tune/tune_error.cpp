#include "tune/tune_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink::tune {
namespace {

/// The error of a step without one of the views; more than any beyond a time budget.
double error_without(const TuneStep& step,
                     std::size_t left_out,
                     const std::vector<std::size_t>& scene_of_view,
                     TuneObjective objective) {
    std::vector<score::CurveCount> scenes(
        *std::max_element(scene_of_view.begin(), scene_of_view.end()) + 1);
    std::vector<bool> is_there(scenes.size(), false);
    for (std::size_t view = 0; view < scene_of_view.size(); ++view) {
        if (view == left_out) continue;
        scenes[scene_of_view[view]] += step.found.by_view[view];
        is_there[scene_of_view[view]] = true;
    }
    std::vector<score::CurveCount> left;  // a scene of one view may be gone
    for (std::size_t i = 0; i < scenes.size(); ++i)
        if (is_there[i]) left.push_back(scenes[i]);
    const bool is_late = step.found.value > 1;
    return error_of(left, objective) + (is_late ? step.found.value : 0);
}

}  // namespace

double scenes_error(const std::vector<score::CurveCount>& scenes) {
    if (scenes.empty()) return 0;
    double sum = 0;
    for (const score::CurveCount& scene : scenes)
        sum += std::sqrt(1 - scene.f());
    const double mean = sum / static_cast<double>(scenes.size());
    return mean * mean;
}

double error_of(const std::vector<score::CurveCount>& scenes, TuneObjective objective) {
    if (objective == TuneObjective::scenes) return scenes_error(scenes);
    score::CurveCount pooled;
    for (const score::CurveCount& scene : scenes)
        pooled += scene;
    return 1 - pooled.f();
}

std::vector<score::CurveCount> leave_one_view_out(const std::vector<TuneStep>& steps,
                                                  const std::vector<std::size_t>& scene_of_view,
                                                  TuneObjective objective) {
    const std::size_t views = scene_of_view.size();
    const bool has_counts = std::all_of(steps.begin(), steps.end(), [&](const TuneStep& step) {
        return step.found.by_view.size() == views;
    });
    if (views < 2 || steps.empty() || !has_counts) return {};
    std::vector<score::CurveCount> left_out;
    for (std::size_t view = 0; view < views; ++view) {
        const TuneStep* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const TuneStep& step : steps) {
            const double error = error_without(step, view, scene_of_view, objective);
            if (error >= least) continue;
            least = error;
            best = &step;
        }
        left_out.push_back(best->found.by_view[view]);
    }
    return left_out;
}

}  // namespace ink::tune
