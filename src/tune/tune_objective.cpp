#include "tune/tune_objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace ink::tune {
namespace {

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

/// The mean root of 1 - F over the scenes of each group.
std::map<std::string, double> mean_roots(const std::map<std::size_t, score::CurveCount>& scenes,
                                         const TuneViews& views,
                                         bool is_by_kind) {
    std::map<std::string, std::pair<double, int>> sums;
    for (const auto& [scene, count] : scenes) {
        auto& sum = sums[is_by_kind ? kind_key(views, scene) : ""];
        sum.first += std::sqrt(1 - count.f());
        ++sum.second;
    }
    std::map<std::string, double> roots;
    for (const auto& [kind, sum] : sums)
        roots[kind] = sum.first / sum.second;
    return roots;
}

/// The error on the views that `is_kept` says.
template <class IsKept>
double error_over(const std::vector<score::CurveCount>& by_view,
                  const TuneViews& views,
                  TuneObjective objective,
                  IsKept is_kept) {
    std::map<std::size_t, score::CurveCount> scenes;
    score::CurveCount pooled;
    for (std::size_t view = 0; view < by_view.size(); ++view) {
        if (!is_kept(view)) continue;
        scenes[views.scene_of_view[view]] += by_view[view];
        pooled += by_view[view];
    }
    if (scenes.empty()) return 0;
    if (objective == TuneObjective::pooled) return 1 - pooled.f();
    double sum = 0;
    double most = 0;
    const auto roots = mean_roots(scenes, views, is_by_kind(objective));
    for (const auto& [kind, root] : roots) {
        sum += root;
        most = std::max(most, root);
    }
    const double mean = sum / static_cast<double>(roots.size());
    return objective == TuneObjective::worst ? most * most : mean * mean;
}

}  // namespace

const std::vector<std::string>& objective_names() {
    static const std::vector<std::string> kNames = {"pooled", "scenes", "kinds", "worst", "ap"};
    return kNames;
}

std::string_view name(TuneObjective objective) {
    return objective_names()[static_cast<std::size_t>(objective)];
}

bool is_by_kind(TuneObjective objective) {
    return objective == TuneObjective::kinds || objective == TuneObjective::worst;
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
