#include "report/text/diff_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/text_table.h"
#include "summary/paired_differences.h"

namespace ink::report {
namespace {

using experiment::MethodDiff;
using experiment::RunDiff;

constexpr std::size_t kMostChanges = 20;  ///< of what was asked; the rest is counted

std::string asked_lines(const RunDiff& diff) {
    if (diff.asked.empty()) return "";
    std::string text = "Asked differently:\n";
    for (std::size_t i = 0; i < std::min(kMostChanges, diff.asked.size()); ++i) {
        const experiment::AskedChange& change = diff.asked[i];
        text += fmt::format("  {}: {} -> {}\n", change.key, change.a, change.b);
    }
    if (diff.asked.size() > kMostChanges)
        text += fmt::format("  and {} more\n", diff.asked.size() - kMostChanges);
    return text;
}

/// "3 cells are new: mote4 (2), ids (1)\n", or "" for none.
std::string cells_line(const std::vector<const harness::Row*>& rows, const std::string& what) {
    if (rows.empty()) return "";
    std::map<std::string, int> by_method;
    for (const harness::Row* row : rows)
        ++by_method[row->method];
    std::string methods;
    for (const auto& [method, count] : by_method)
        methods += fmt::format("{}{} ({})", methods.empty() ? "" : ", ", method, count);
    return fmt::format("{} {}: {}\n", rows.size(), what, methods);
}

/// F before and after, and their difference.
void add_f(const MethodDiff& method, const experiment::FDiff& f, std::vector<std::string>& line) {
    line.push_back(core::format_share(f.before));
    line.push_back(core::format_share(f.after));
    if (f.difference && method.changed_scores > 0) {
        line.push_back(summary::format_paired_difference(
            {method.method, method.method, *f.difference, f.range}));
    } else {
        line.emplace_back(f.difference ? "0" : "-");
    }
}

/// A line for every method that changed; of all methods if only times are to be seen.
core::Cells cells_of(const RunDiff& diff, bool with_times) {
    const bool has_ink = std::ranges::any_of(
        diff.methods, [](const MethodDiff& method) { return method.soft_f.before.has_value(); });
    core::Cells cells{{"method", "cells", "images changed", "F before", "F after", "difference"}};
    if (has_ink) {
        for (const char* title : {"soft F before", "soft F after", "difference"})
            cells[0].emplace_back(title);
    }
    if (with_times) cells[0].emplace_back("time");
    cells[0].emplace_back("settings, status");
    for (const MethodDiff& method : diff.methods) {
        if (method.is_same()) continue;
        std::vector<std::string> line{method.method,
                                      fmt::format("{}", method.cells),
                                      fmt::format("{}", method.changed_images)};
        add_f(method, method.f, line);
        if (has_ink) add_f(method, method.soft_f, line);
        if (with_times) {
            line.push_back(method.time_ratio ? fmt::format("x {:.2f}", *method.time_ratio) : "-");
        }
        std::string notes = method.settings;
        const auto add = [&](int count, std::string_view what) {
            if (count > 0) notes += fmt::format("{}{} {}", notes.empty() ? "" : "; ", count, what);
        };
        add(method.lost, "no longer scored");
        add(method.won, "newly scored");
        if (method.is_worse()) notes += notes.empty() ? "worse" : "; worse";
        line.push_back(notes);
        cells.push_back(std::move(line));
    }
    return cells;
}

/// Drawing times of all methods together, and the two that moved most.
std::string times_line(const RunDiff& diff) {
    if (!diff.times_obstacle.empty())
        return fmt::format("Times do not compare: {}\n", diff.times_obstacle);
    std::vector<const MethodDiff*> timed;
    for (const MethodDiff& method : diff.methods) {
        if (method.time_ratio) timed.push_back(&method);
    }
    if (timed.empty()) return "";
    const auto [least, most] = std::ranges::minmax_element(
        timed, [](const auto* a, const auto* b) { return *a->time_ratio < *b->time_ratio; });
    return fmt::format("Drawing times, after over before: from {:.2f} ({}) to {:.2f} ({})\n",
                       *(*least)->time_ratio,
                       (*least)->method,
                       *(*most)->time_ratio,
                       (*most)->method);
}

}  // namespace

std::string diff_text(const RunDiff& diff) {
    std::string text = asked_lines(diff) + cells_line(diff.cells.added, "cells are new") +
                       cells_line(diff.cells.gone, "cells are gone");
    if (diff.changed_truths > 0)
        text += fmt::format("On {} views the truth itself differs\n", diff.changed_truths);
    const bool with_times = diff.times_obstacle.empty();
    const core::Cells cells = cells_of(diff, with_times);
    const std::size_t changed = cells.size() - 1;
    if (changed > 0) text += core::aligned(cells);
    const std::size_t same = diff.methods.size() - changed;
    if (diff.is_same()) {
        text += fmt::format(
            "Nothing differs: {} cells of {} methods\n", diff.cells.paired.size(), same);
    } else if (same > 0) {
        text += fmt::format("{} methods are the same in both\n", same);
    }
    return text + times_line(diff);
}

}  // namespace ink::report
