#include "report/text/verdict_terms.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text_table.h"
#include "harness/cell.h"
#include "report/text/verdict.h"

namespace ink::report {
namespace {

bool any(const std::vector<experiment::MethodSummary>& summaries,
         bool (*has)(const experiment::MethodSummary&)) {
    return std::any_of(summaries.begin(), summaries.end(), has);
}

TextColumn curve_column(std::string heading, double (*value)(const statistics::CurveSummary&)) {
    return {std::move(heading), [value](const experiment::MethodSummary& s) {
                return s.curve ? core::format_share(value(*s.curve)) : "-";
            }};
}

void add_threshold_columns(std::vector<TextColumn>& columns) {
    columns.push_back({"threshold", [](const experiment::MethodSummary& s) {
                           return s.threshold ? fmt::format("{}", *s.threshold) : "-";
                       }});
    columns.push_back({"best", [](const experiment::MethodSummary& s) {
                           return s.curve ? fmt::format("{}", s.curve->ods.threshold) : "-";
                       }});
    columns.push_back(
        curve_column("ODS", [](const statistics::CurveSummary& c) { return c.ods.f; }));
    columns.push_back(curve_column("OIS", [](const statistics::CurveSummary& c) { return c.ois; }));
    columns.push_back(curve_column("AP", [](const statistics::CurveSummary& c) { return c.ap; }));
}

const experiment::MethodSummary* find(const std::vector<experiment::MethodSummary>& summaries,
                                      const std::string& method) {
    const auto found = std::find_if(
        summaries.begin(), summaries.end(), [&](const auto& s) { return s.method == method; });
    return found == summaries.end() ? nullptr : &*found;
}

}  // namespace

std::vector<TextColumn> statistics_columns(
    const std::vector<experiment::MethodSummary>& summaries) {
    std::vector<TextColumn> columns;
    if (any(summaries, [](const experiment::MethodSummary& s) { return s.f_random.has_value(); })) {
        columns.push_back(share_column("random", &experiment::MethodSummary::f_random));
    }
    if (any(summaries, [](const experiment::MethodSummary& s) { return s.curve.has_value(); })) {
        add_threshold_columns(columns);
    }
    if (any(summaries,
            [](const experiment::MethodSummary& s) { return !s.f_at_tolerances.empty(); })) {
        for (std::size_t i = 0; i < harness::kTolerances_px.size(); ++i) {
            columns.push_back({fmt::format("{} px", harness::kTolerances_px[i]),
                               [i](const experiment::MethodSummary& s) {
                                   return i < s.f_at_tolerances.size()
                                              ? core::format_share(s.f_at_tolerances[i])
                                              : "-";
                               }});
        }
    }
    return columns;
}

core::Cells paired_difference_cells(const std::vector<experiment::PairedDifference>& differences) {
    std::vector<std::string> methods;
    for (const experiment::PairedDifference& paired : differences) {
        if (std::find(methods.begin(), methods.end(), paired.a) == methods.end()) {
            methods.push_back(paired.a);
        }
    }
    if (methods.empty()) return {};
    core::Cells cells(1, {"F minus F of"});
    cells[0].insert(cells[0].end(), methods.begin(), methods.end());
    for (const std::string& a : methods) {
        std::vector<std::string>& line = cells.emplace_back(1, a);
        for (const std::string& b : methods) {
            const auto paired = std::find_if(
                differences.begin(), differences.end(), [&](const experiment::PairedDifference& l) {
                    return l.a == a && l.b == b;
                });
            line.push_back(
                paired == differences.end() ? "" : experiment::format_paired_difference(*paired));
        }
    }
    return cells;
}

const std::vector<std::pair<std::string, std::string>>& definitions() {
    static const std::vector<std::pair<std::string, std::string>> kDefinitions = {
        {"F", "matched pixels, counted twice, over drawn plus true ones, of all views together"},
        {"95 %", "where F would lie for other scenes like these: scenes resampled 2000 times"},
        {"macro", "mean over scenes, each counting alike; F counts every pixel alike"},
        {"random", "F of a random image of as many pixels"},
        {"threshold", "of edge response, at which the method is scored"},
        {"best", "the threshold with the highest F over these views, which is ODS"},
        {"OIS", "F if every view had its own best threshold"},
        {"AP", "area under precision against recall over all thresholds"},
        {"1 px .. 4 px", "F with matches at most so far apart"},
    };
    return kDefinitions;
}

std::string threshold_lines(const std::vector<harness::Row>& rows,
                            const std::vector<statistics::CellCurve>& curves) {
    const std::vector<experiment::MethodSummary> summaries = experiment::summarise(rows);
    std::string lines;
    for (const statistics::OdsPoint& point : statistics::ods_on_training(curves)) {
        const experiment::MethodSummary* s = find(summaries, point.method);
        lines += fmt::format("{}: best threshold over these training scenes {} (F {} pooled)",
                             point.method,
                             point.threshold,
                             core::format_share(point.f));
        if (s != nullptr && s->threshold && s->f_train) {
            lines += fmt::format(
                "; its own, {}, has F {}", *s->threshold, core::format_share(s->f_train));
        }
        lines += '\n';
    }
    return lines;
}

}  // namespace ink::report
