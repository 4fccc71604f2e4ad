#include "harness/csv_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace ink::harness {
namespace {

/// One record of `text` from `at` on, which moves behind its line break.
std::vector<std::string> take_record(std::string_view text, std::size_t& at) {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') is_quoted = !is_quoted;  // a doubled quote closes and opens again
        if (!is_quoted && c == '\n') {
            ++at;
            break;
        }
        if (!is_quoted && c == ',') {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

}  // namespace

std::size_t CsvTable::find(std::string_view name) const {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                    columns.begin());
}

CsvTable split_csv(std::string_view text, const std::string& where) {
    CsvTable table;
    std::size_t at = 0;
    if (text.empty()) return table;
    table.columns = take_record(text, at);
    while (at < text.size()) {
        table.records.push_back(take_record(text, at));
        if (table.records.back().size() != table.columns.size()) {
            throw core::Error(fmt::format("{}, record {}", where, table.records.size()),
                              fmt::format("it has {} fields", table.records.back().size()),
                              fmt::format("{}, as many as the heading", table.columns.size()));
        }
    }
    return table;
}

std::string join_csv(const CsvTable& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const std::vector<std::string>& record : table.records)
        text += fmt::format("{}\n", fmt::join(record, ","));
    return text;
}

std::string unquoted(const std::string& field) {
    if (field.size() < 2 || field.front() != '"') return field;
    std::string text;
    for (std::size_t i = 1; i + 1 < field.size(); ++i) {
        if (field[i] == '"') ++i;
        text += field[i];
    }
    return text;
}

const std::set<std::string>& time_columns() {
    static const std::set<std::string> kNames = {
        // rows.csv, sweep.csv, stress.csv; draw_n is how often a time budget let draw.
        "prepare_ns",
        "pose_ns",
        "draw_ns",
        "draw_ns_q25",
        "draw_ns_q75",
        "draw_ns_min",
        "draw_n",
        "predicted_ns",
        "cost_residual",
        // summary.csv, stress_summary.csv
        "draw_ms",
        "draw_ms_lo",
        "draw_ms_hi",
        // scaling.csv
        "noise",
        // timedemo.csv
        "fill_ns",
        "shade_ns",
        "compose_ns",
    };
    return kNames;
}

std::string without_times(const std::string& heading, const std::string& lines) {
    CsvTable table = split_csv(heading + "\n" + lines, "without_times");
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (!time_columns().contains(table.columns[i])) continue;
        for (std::vector<std::string>& record : table.records)
            record[i].clear();
    }
    return join_csv(table).substr(heading.size() + 1);
}

}  // namespace ink::harness
