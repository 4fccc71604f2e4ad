#include "experiment/summary/sweep_summary.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "experiment/summary/summary.h"

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
    return SettingSummary{difference(rows.front().params, usual), *s.draw_ms, 1 - *s.f_2px};
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

}  // namespace

std::vector<MethodSweep> summarise_sweep(const std::vector<harness::Row>& rows,
                                         const std::vector<harness::Row>& sweep) {
    std::vector<MethodSweep> methods;
    const auto usual = usual_params(rows);
    for (const std::vector<harness::Row>& of_setting : by_setting(sweep)) {
        const std::string& method = of_setting.front().method;
        const auto found = usual.find(method);
        const auto setting =
            summarise_setting(of_setting, found == usual.end() ? "" : found->second);
        if (!setting) continue;
        auto known = std::find_if(
            methods.begin(), methods.end(), [&](const auto& m) { return m.method == method; });
        if (known == methods.end()) known = methods.insert(known, MethodSweep{method, {}});
        known->settings.push_back(*setting);
    }
    return methods;
}

}  // namespace ink::experiment
