#include "experiment/summary_csv.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>

#include "experiment/class_recalls.h"
#include "experiment/summary.h"
#include "harness/csv.h"
#include "truth/line_class.h"

namespace ink::experiment {
namespace {

/// What a line is made from.
struct Line {
    const MethodSummary& summary;
    std::map<std::string, statistics::Interval> recall_ranges;
};

struct Column {
    std::string name;
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

void add_recalls(std::vector<Column>& columns) {
    for (const truth::LineClass c : truth::kLineClasses) {
        const std::string name(truth::name(c));
        const std::string key = "recall_" + name;
        columns.push_back({key, [name](const Line& line) {
                               return text_of(find_in(line.summary.recall_by_class, name));
                           }});
        columns.push_back({key + "_lo", [name](const Line& line) {
                               return text_of(low_of(find_in(line.recall_ranges, name)));
                           }});
        columns.push_back({key + "_hi", [name](const Line& line) {
                               return text_of(high_of(find_in(line.recall_ranges, name)));
                           }});
    }
}

std::vector<Column> make_columns() {
    using S = MethodSummary;
    std::vector<Column> columns;
    const auto add = [&columns](std::string name, auto value_of) {
        columns.push_back({std::move(name), [value_of](const Line& line) {
                               return text_of(std::optional(value_of(line.summary)));
                           }});
    };
    const auto add_if_there = [&columns](std::string name, auto value_of) {
        columns.push_back({std::move(name), [value_of](const Line& line) {
                               return text_of(value_of(line.summary));
                           }});
    };
    add("method", [](const S& s) { return harness::csv_field(s.method); });
    add("kind", [](const S& s) { return std::string(s.is_bracket ? "bracket" : "method"); });
    add("views", [](const S& s) { return s.views; });
    add("scenes", [](const S& s) { return s.scenes; });
    add("failed", [](const S& s) { return s.failed; });
    add_if_there("f_2px", [](const S& s) { return s.f_2px; });
    add_if_there("f_lo", [](const S& s) { return low_of(s.f_2px_range); });
    add_if_there("f_hi", [](const S& s) { return high_of(s.f_2px_range); });
    add_if_there("f_train", [](const S& s) { return s.f_train; });
    add_if_there("f_heldout", [](const S& s) { return s.f_heldout; });
    add_if_there("f_macro", [](const S& s) { return s.f_macro; });
    add_if_there("f_1px", [](const S& s) { return s.f_1px; });
    add_if_there("precision", [](const S& s) { return s.precision; });
    add_if_there("recall", [](const S& s) { return s.recall; });
    add_if_there("ap",
                 [](const S& s) { return s.curve ? std::optional(s.curve->ap) : std::nullopt; });
    add_if_there("draw_ms", [](const S& s) { return s.draw_ms; });
    add_if_there("draw_ms_lo", [](const S& s) { return low_of(s.draw_ms_quartiles); });
    add_if_there("draw_ms_hi", [](const S& s) { return high_of(s.draw_ms_quartiles); });
    add_if_there("bytes_per_px", [](const S& s) { return s.bytes_per_px; });
    add_recalls(columns);
    return columns;
}

const std::vector<Column>& columns() {
    static const std::vector<Column> kColumns = make_columns();
    return kColumns;
}

}  // namespace

const std::vector<std::string>& summary_columns() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Column& column : columns())
            names.push_back(column.name);
        return names;
    }();
    return kNames;
}

std::string summary_csv(const std::vector<harness::Row>& rows,
                        const std::vector<statistics::CellCurve>& curves) {
    std::vector<MethodSummary> summaries = summarise(rows);
    add_curves(curves, summaries);
    std::string text = fmt::format("{}\n", fmt::join(summary_columns(), ","));
    for (const MethodSummary& summary : summaries) {
        const Line line{summary, class_recall_intervals(rows_of_method(rows, summary.method))};
        std::vector<std::string> fields;
        for (const Column& column : columns())
            fields.push_back(column.field(line));
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace ink::experiment
