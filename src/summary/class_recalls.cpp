#include "summary/class_recalls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/bootstrap.h"

namespace ink::summary {
namespace {

/// What one class has in each scene, in order of first appearance.
using SceneCounts = std::vector<std::pair<std::string, score::CurveCount>>;

score::CurveCount& counts_of(SceneCounts& scenes, const std::string& scene) {
    const auto known =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return s.first == scene; });
    if (known != scenes.end()) return known->second;
    return scenes.emplace_back(scene, score::CurveCount{}).second;
}

}  // namespace

std::map<std::string, statistics::Interval> class_recall_intervals(
    const std::vector<const harness::Row*>& rows) {
    std::map<std::string, SceneCounts> classes;
    for (const harness::Row* row : rows) {
        if (!row->is_ok()) continue;
        for (const auto& [name, recall] : row->recall_by_class) {
            const auto truth_px = row->truth_px_by_class.find(name);
            if (truth_px == row->truth_px_by_class.end() || truth_px->second == 0) continue;
            const std::int64_t n = truth_px->second;
            // Found of n, with n "drawn": F of these counts, 2 k / (n + n), is the recall.
            counts_of(classes[name], row->scene) +=
                score::CurveCount{std::llround(recall * static_cast<double>(n)), n, n};
        }
    }
    std::map<std::string, statistics::Interval> intervals;
    for (const auto& [name, scenes] : classes) {
        std::vector<score::CurveCount> counts;
        for (const auto& scene : scenes)
            counts.push_back(scene.second);
        const auto interval = statistics::f_interval(counts, {.seed = rows.front()->seed});
        if (interval) intervals[name] = *interval;
    }
    return intervals;
}

std::vector<const harness::Row*> rows_of_method(const std::vector<harness::Row>& rows,
                                                const std::string& method) {
    std::vector<const harness::Row*> kept;
    for (const harness::Row& row : rows) {
        if (row.method == method && row.is_ok()) kept.push_back(&row);
    }
    return kept;
}

}  // namespace ink::summary
