#include "experiment/summary/summary_csv.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>

#include "experiment/summary/class_recalls.h"
#include "experiment/summary/summary.h"
#include "harness/tables/csv.h"
#include "truth/line_class.h"

namespace ink::experiment {
namespace {

/// What a line is made from.
struct Line {
    const MethodSummary& summary;
    std::map<std::string, statistics::Interval> recall_ranges;
};

struct SummaryColumn {
    harness::Column column;
    std::function<std::string(const Line&)> field;
};

template <class T>
std::string text_of(const std::optional<T>& value) {
    return value ? fmt::format("{}", *value) : "";
}

std::optional<double> low_of(const std::optional<statistics::Interval>& range) {
    return range ? std::optional(range->low) : std::nullopt;
}

std::optional<double> high_of(const std::optional<statistics::Interval>& range) {
    return range ? std::optional(range->high) : std::nullopt;
}

template <class T>
std::optional<T> find_in(const std::map<std::string, T>& values, const std::string& key) {
    const auto found = values.find(key);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

void add_recalls(std::vector<SummaryColumn>& columns) {
    for (const truth::LineClass c : truth::kLineClasses) {
        const std::string name(truth::name(c));
        const std::string key = "recall_" + name;
        columns.push_back(
            {{key, "0..1", "recall of this class, pooled over views"}, [name](const Line& line) {
                 return text_of(find_in(line.summary.recall_by_class, name));
             }});
        columns.push_back(
            {{key + "_lo", "0..1", "lower end of its 95 % interval"}, [name](const Line& line) {
                 return text_of(low_of(find_in(line.recall_ranges, name)));
             }});
        columns.push_back({{key + "_hi", "0..1", "upper end"}, [name](const Line& line) {
                               return text_of(high_of(find_in(line.recall_ranges, name)));
                           }});
    }
}

void add_f(std::vector<SummaryColumn>& columns) {
    using S = MethodSummary;
    const auto add = [&columns](std::string name, auto value_of, std::string doc) {
        columns.push_back({{std::move(name), "0..1", std::move(doc)}, [value_of](const Line& line) {
                               return text_of(value_of(line.summary));
                           }});
    };
    add(
        "f_2px", [](const S& s) { return s.f_2px; }, "F within 2 px of the counts of all views");
    add(
        "f_lo",
        [](const S& s) { return low_of(s.f_2px_range); },
        "lower end of its 95 % interval, scenes resampled");
    add(
        "f_hi", [](const S& s) { return high_of(s.f_2px_range); }, "upper end");
    add(
        "f_train", [](const S& s) { return s.f_train; }, "the same over training scenes");
    add(
        "f_heldout", [](const S& s) { return s.f_heldout; }, "the same over held-out scenes");
    add(
        "f_macro", [](const S& s) { return s.f_macro; }, "mean of the scenes' own F");
    add(
        "f_1px", [](const S& s) { return s.f_1px; }, "F within 1 px of the counts of all views");
    add(
        "precision", [](const S& s) { return s.precision; }, "pooled, within 2 px");
    add(
        "recall", [](const S& s) { return s.recall; }, "pooled, within 2 px");
    add(
        "ap",
        [](const S& s) { return s.curve ? std::optional(s.curve->ap) : std::nullopt; },
        "area under the precision envelope of the pooled curves");
}

void add_times(std::vector<SummaryColumn>& columns) {
    using S = MethodSummary;
    const auto add = [&columns](std::string name, auto value_of, std::string doc) {
        columns.push_back(
            {{std::move(name), "ms", std::move(doc), true},
             [value_of](const Line& line) { return text_of(value_of(line.summary)); }});
    };
    add(
        "draw_ms", [](const S& s) { return s.draw_ms; }, "median over views of draw_ns");
    add(
        "draw_ms_lo", [](const S& s) { return low_of(s.draw_ms_quartiles); }, "lower quartile");
    add(
        "draw_ms_hi", [](const S& s) { return high_of(s.draw_ms_quartiles); }, "upper quartile");
}

std::vector<SummaryColumn> make_columns() {
    using S = MethodSummary;
    std::vector<SummaryColumn> columns;
    const auto add = [&columns](std::string name, auto value_of, std::string doc) {
        columns.push_back({{std::move(name), "", std::move(doc)}, [value_of](const Line& line) {
                               return text_of(std::optional(value_of(line.summary)));
                           }});
    };
    add(
        "method", [](const S& s) { return harness::csv_field(s.method); }, "as in rows.csv");
    add(
        "kind",
        [](const S& s) { return std::string(s.is_baseline ? "baseline" : "method"); },
        "method or baseline");
    add(
        "views", [](const S& s) { return s.views; }, "on which it was scored");
    add(
        "scenes", [](const S& s) { return s.scenes; }, "of these views");
    add(
        "failed", [](const S& s) { return s.failed; }, "cells without a score");
    add_f(columns);
    add_times(columns);
    columns.push_back({{"bytes_per_px", "B/px", "of the method's buffers, depth included"},
                       [](const Line& line) { return text_of(line.summary.bytes_per_px); }});
    add_recalls(columns);
    return columns;
}

const std::vector<SummaryColumn>& columns() {
    static const std::vector<SummaryColumn> kColumns = make_columns();
    return kColumns;
}

}  // namespace

const harness::TableInfo& summary_table() {
    static const harness::TableInfo kTable = [] {
        harness::TableInfo table{
            "summary.csv", "A line per method, over all cells of study `compare`.", {}};
        for (const SummaryColumn& each : columns())
            table.columns.push_back(each.column);
        return table;
    }();
    return kTable;
}

std::string summary_csv(const std::vector<harness::Row>& rows,
                        const std::vector<statistics::CellCurve>& curves) {
    std::vector<MethodSummary> summaries = summarise(rows);
    add_curves(curves, summaries);
    std::string text = harness::heading(summary_table());
    for (const MethodSummary& summary : summaries) {
        const Line line{summary, class_recall_intervals(rows_of_method(rows, summary.method))};
        std::vector<std::string> fields;
        for (const SummaryColumn& column : columns())
            fields.push_back(column.field(line));
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace ink::experiment
