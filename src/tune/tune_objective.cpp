#include "tune/tune_objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "statistics/spread.h"

namespace ink::tune {
namespace {

constexpr double kMostGain = 0.03;  // of a scene, for TuneObjective::even

/// What a scene is pooled under: its kind, or itself.
std::string kind_key(const TuneViews& views, std::size_t scene) {
    const std::string& kind = views.kind_of_scene[scene];
    return kind.empty() ? fmt::format("/{}", scene) : kind;
}

/// What is left out together with a view.
std::vector<std::string> groups_of(const TuneViews& views, TuneObjective objective) {
    std::vector<std::string> groups;
    for (std::size_t view = 0; view < views.scene_of_view.size(); ++view) {
        groups.push_back(is_by_kind(objective) ? kind_key(views, views.scene_of_view[view])
                                               : fmt::format("{}", view));
    }
    return groups;
}

using SceneCounts = std::map<std::size_t, score::CurveCount>;

/// The mean of `value_of(scene, its counts)` over the scenes of each kind.
template <class ValueOf>
std::vector<double> means_of_kinds(const SceneCounts& scenes,
                                   const TuneViews& views,
                                   ValueOf value_of) {
    std::map<std::string, std::pair<double, int>> sums;
    for (const auto& [scene, count] : scenes) {
        auto& sum = sums[kind_key(views, scene)];
        sum.first += value_of(scene, count);
        ++sum.second;
    }
    std::vector<double> means;
    for (const auto& [kind, sum] : sums)
        means.push_back(sum.first / sum.second);
    return means;
}

/// Of values of which there is one at least.
double mean_of(const std::vector<double>& values) {
    return statistics::mean(values).value();
}

/// Counts of the views that `is_kept` says, summed by scene.
template <class IsKept>
SceneCounts sums_of(const std::vector<score::CurveCount>& by_view,
                    const TuneViews& views,
                    IsKept is_kept) {
    SceneCounts scenes;
    for (std::size_t view = 0; view < by_view.size(); ++view) {
        if (is_kept(view)) scenes[views.scene_of_view[view]] += by_view[view];
    }
    return scenes;
}

/// The error on the views that `is_kept` says.
template <class IsKept>
double error_over(const std::vector<score::CurveCount>& by_view,
                  const TuneViews& views,
                  TuneObjective objective,
                  IsKept is_kept) {
    const SceneCounts scenes = sums_of(by_view, views, is_kept);
    if (scenes.empty()) return 0;
    const auto root_of = [](std::size_t, const score::CurveCount& count) {
        return std::sqrt(1 - count.f());
    };
    if (objective == TuneObjective::pooled) {
        score::CurveCount pooled;
        for (const auto& [scene, count] : scenes)
            pooled += count;
        return 1 - pooled.f();
    }
    if (objective == TuneObjective::scenes) {
        std::vector<double> roots;
        for (const auto& [scene, count] : scenes)
            roots.push_back(root_of(scene, count));
        return mean_of(roots) * mean_of(roots);
    }
    if (objective == TuneObjective::even) {
        const SceneCounts start =
            sums_of(views.at_start.empty() ? by_view : views.at_start, views, is_kept);
        const auto error = [](std::size_t, const score::CurveCount& count) {
            return 1 - count.f();
        };
        const auto gain = [&](std::size_t scene, const score::CurveCount& count) {
            return std::clamp(count.f() - start.at(scene).f(), -kMostGain, kMostGain);
        };
        return mean_of(means_of_kinds(start, views, error)) -
               mean_of(means_of_kinds(scenes, views, gain));
    }
    const std::vector<double> roots = means_of_kinds(scenes, views, root_of);
    const double root =
        objective == TuneObjective::worst ? std::ranges::max(roots) : mean_of(roots);
    return root * root;
}

}  // namespace

const std::vector<std::string>& objective_names() {
    static const std::vector<std::string> kNames = {"pooled", "scenes", "kinds", "worst", "even"};
    return kNames;
}

std::string_view name(TuneObjective objective) {
    return objective_names()[static_cast<std::size_t>(objective)];
}

bool is_by_kind(TuneObjective objective) {
    return objective == TuneObjective::kinds || objective == TuneObjective::worst ||
           objective == TuneObjective::even;
}

double f_of(const std::vector<score::CurveCount>& scenes) {
    score::CurveCount pooled;
    for (const score::CurveCount& scene : scenes)
        pooled += scene;
    return pooled.f();
}

double error_of(const std::vector<score::CurveCount>& by_view,
                const TuneViews& views,
                TuneObjective objective) {
    return error_over(by_view, views, objective, [](std::size_t) { return true; });
}

std::vector<score::CurveCount> leave_one_out(const std::vector<TuneStep>& steps,
                                             const TuneViews& views,
                                             TuneObjective objective) {
    const std::vector<std::string> groups = groups_of(views, objective);
    const bool has_counts = std::ranges::all_of(
        steps, [&](const TuneStep& step) { return step.found.by_view.size() == groups.size(); });
    const std::set<std::string> all(groups.begin(), groups.end());
    if (all.size() < 2 || steps.empty() || !has_counts) return {};
    std::vector<score::CurveCount> left_out(groups.size());
    for (const std::string& group : all) {
        const TuneStep* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const TuneStep& step : steps) {
            const double late = step.found.value > 1 ? step.found.value : 0;
            const double error =
                late + error_over(step.found.by_view, views, objective, [&](std::size_t view) {
                    return groups[view] != group;
                });
            if (error >= least) continue;
            least = error;
            best = &step;
        }
        for (std::size_t view = 0; view < groups.size(); ++view) {
            if (groups[view] == group) left_out[view] = best->found.by_view[view];
        }
    }
    return left_out;
}

}  // namespace ink::tune
