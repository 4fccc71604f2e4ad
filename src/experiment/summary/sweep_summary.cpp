#include "experiment/summary/sweep_summary.h"

#include <algorithm>
#include <map>
#include <set>

namespace ink::experiment {
namespace {

std::set<std::string> split_params(const std::string& params) {
    std::set<std::string> parts;
    std::size_t begin = 0;
    while (begin < params.size()) {
        const auto end = std::min(params.find(';', begin), params.size());
        parts.insert(params.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// The parts of `params` that `usual` has not: "fatten=true, packing=pixel".
std::string difference(const std::string& params, const std::string& usual) {
    const std::set<std::string> known = split_params(usual);
    std::string text;
    for (const std::string& part : split_params(params)) {
        if (known.count(part) == 0) text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

/// The settings of a method in this run: what is called its default in tables and charts.
std::map<std::string, std::string> usual_params(const std::vector<harness::Row>& rows) {
    std::map<std::string, std::string> usual;
    for (const harness::Row& row : rows) {
        if (!harness::is_baseline(row.method)) usual.emplace(row.method, row.params);
    }
    return usual;
}

/// Rows of one method and setting; summarise() takes them for a method of their own.
std::optional<SettingSummary> summarise_setting(const std::vector<harness::Row>& rows,
                                                const std::string& usual) {
    const MethodSummary s = summarise(rows).front();
    if (!s.f_2px || !s.draw_ms || *s.draw_ms <= 0) return std::nullopt;
    SettingSummary setting;
    setting.params = rows.front().params;
    setting.difference = difference(setting.params, usual);
    setting.draw_ms = *s.draw_ms;
    setting.draw_ms_quartiles = s.draw_ms_quartiles;
    setting.error = 1 - *s.f_2px;
    if (s.f_2px_range) setting.error_range = {1 - s.f_2px_range->high, 1 - s.f_2px_range->low};
    return setting;
}

/// Rows by method and setting, both in order of first appearance.
std::vector<std::vector<harness::Row>> by_setting(const std::vector<harness::Row>& rows) {
    std::vector<std::vector<harness::Row>> groups;
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    for (const harness::Row& row : rows) {
        if (harness::is_baseline(row.method) || !row.is_ok()) continue;
        const auto [found, is_new] =
            known.emplace(std::pair{row.method, row.params}, groups.size());
        if (is_new) groups.emplace_back();
        groups[found->second].push_back(row);
    }
    return groups;
}

void find_front(MethodSweep& sweep) {
    std::vector<CostPoint> points;
    for (const SettingSummary& setting : sweep.settings)
        points.push_back({setting.draw_ms, setting.error});
    sweep.front = pareto_front(points);
}

}  // namespace

Fronts summarise_fronts(const std::vector<harness::Row>& rows,
                        const std::vector<harness::Row>& sweep) {
    Fronts fronts;
    fronts.is_swept = !sweep.empty();
    const std::vector<harness::Row>& shown = fronts.is_swept ? sweep : rows;
    const auto usual = usual_params(rows);
    for (const std::vector<harness::Row>& of_setting : by_setting(shown)) {
        const std::string& method = of_setting.front().method;
        const auto found = usual.find(method);
        const auto setting =
            summarise_setting(of_setting, found == usual.end() ? "" : found->second);
        if (!setting) continue;
        auto known = std::find_if(fronts.methods.begin(), fronts.methods.end(), [&](const auto& m) {
            return m.method == method;
        });
        if (known == fronts.methods.end()) {
            known = fronts.methods.insert(known, MethodSweep{method, {}, {}});
        }
        known->settings.push_back(*setting);
    }
    for (MethodSweep& method : fronts.methods)
        find_front(method);

    std::set<harness::Place> places;
    std::set<std::string> scenes;
    for (const harness::Row& row : shown) {
        places.insert(harness::place_of(row));
        scenes.insert(row.scene);
    }
    std::vector<harness::Row> baselines;
    std::copy_if(
        rows.begin(), rows.end(), std::back_inserter(baselines), [&](const harness::Row& row) {
            return harness::is_baseline(row.method) && places.count(harness::place_of(row)) != 0;
        });
    fronts.baselines = summarise(baselines);
    fronts.views = static_cast<int>(places.size());
    fronts.scenes = static_cast<int>(scenes.size());
    return fronts;
}

}  // namespace ink::experiment
