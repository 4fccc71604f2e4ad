#include "harness/tables/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "harness/tables/cost_tables.h"
#include "harness/tables/row_parts.h"

namespace ink::harness {
namespace {

constexpr std::string_view kFile = "sweep.csv";
constexpr const char* kDoc =
    "A line per cell and setting of its method that a sweep tried. Method, scene, view and size "
    "are "
    "those of the cell in rows.csv, and so are the parameters without a column here; a parameter "
    "is "
    "a column if any setting of the run changes it.";

/// The columns behind the swept parameters.
constexpr const char* kNumbers[] = {"f_2px",
                                    "precision_2px",
                                    "recall_2px",
                                    "k_2px",
                                    "n_pred",
                                    "n_truth",
                                    "unmatched_duplicates",
                                    "false_positives",
                                    "unmatched_truth",
                                    "false_negatives",
                                    "prepare_ns",
                                    "pose_ns",
                                    "draw_ns",
                                    "draw_ns_q25",
                                    "draw_ns_q75",
                                    "draw_ns_min",
                                    "draw_n",
                                    "bytes_per_px",
                                    "image_hash"};

/// A setting: the row of its cell, with what the setting changes.
struct Setting : RowRecord {
    int number = 0;
};
using SettingTable = TableOf<Setting>;

std::string value_of(const std::string& params, const std::string& key) {
    for (const auto& [name, value] : split_params(params)) {
        if (name == key) return value;
    }
    return "";
}

/// `params` with another value of `key`, if it is among them.
std::string with_value(const std::string& params,
                       const std::string& key,
                       const std::string& value) {
    std::string changed;
    for (const auto& [name, own] : split_params(params)) {
        changed +=
            fmt::format("{}{}={}", changed.empty() ? "" : ";", name, name == key ? value : own);
    }
    return changed;
}

void add_parameter(SettingTable& table, const std::string& key) {
    table.add(
        {key, "", "the parameter of this name; empty if the method has none"},
        [key](const Setting& s) { return csv_field(value_of(s.row.params, key)); },
        [key](const CsvField& field, Setting& s) {
            if (field.is_empty()) return;
            s.row.params = with_value(s.row.params, key, field.text());
            if (key == "threshold") field.read(s.row.threshold);
        });
}

SettingTable make_table(const std::vector<std::string>& swept) {
    SettingTable table{std::string(kFile), kDoc};
    table.add({"cell", "", "of rows.csv: this method at its own settings on this view"},
              &Setting::cell);
    table.add({"setting", "", "counted from 1 within the cell"}, &Setting::number);
    table.add_like(rows_table(), "status");
    for (const std::string& key : swept)
        add_parameter(table, key);
    for (const char* name : kNumbers)
        table.add_like(rows_table(), name);
    for (const Column& column : cost_table().info().columns)
        if (column.name != "cell") table.add_like(cost_table(), column.name);
    std::set<std::string> names;
    for (const Column& column : table.info().columns) {
        if (names.insert(column.name).second) continue;
        throw core::Error(std::string(kFile),
                          fmt::format("a parameter is called {}, as a column is", column.name),
                          "parameters with other names");
    }
    return table;
}

/// What of a cell's row holds at every setting too.
Row place_of_setting(const Row& own) {
    Row row = own;
    clear_scores(row);
    clear_times(row);
    row.threshold.reset();
    row.with_crowded_2px.reset();
    row.cost.reset();
    row.skips.reset();
    row.rounding_px = 0;
    row.clock = Row().clock;
    return row;
}

}  // namespace

TableInfo sweep_table(const std::vector<std::string>& swept) {
    return make_table(swept).info();
}

std::string sweep_line(std::int64_t cell,
                       int setting,
                       const std::vector<std::string>& swept,
                       const Row& row) {
    return make_table(swept).line({{cell, Study::compare, row}, setting});
}

std::vector<std::string> swept_parameters(const CsvTable& csv) {
    const std::size_t first = csv.find("status") + 1;
    const std::size_t end = csv.find(kNumbers[0]);
    std::vector<std::string> swept;
    for (std::size_t i = first; i < end && i < csv.columns.size(); ++i)
        swept.push_back(unquoted(csv.columns[i]));
    return swept;
}

std::vector<Row> read_sweep(const CsvTable& csv, const RowIndex& own) {
    const SettingTable table = make_table(swept_parameters(csv));
    check_columns(csv, table.info());
    std::vector<Row> rows;
    for (std::size_t i = 0; i < csv.records.size(); ++i) {
        Setting setting;
        setting.row = place_of_setting(own.find(CsvField(csv, i, 0)).row);
        table.read_into(csv, i, setting);
        setting.row.truth_px = setting.row.n_truth;
        setting.row.setting = setting.number;
        rows.push_back(std::move(setting.row));
    }
    return rows;
}

std::vector<std::pair<std::string, std::string>> split_params(const std::string& params) {
    std::vector<std::pair<std::string, std::string>> pairs;
    std::istringstream stream(params);
    for (std::string part; std::getline(stream, part, ';');) {
        const auto equals = part.find('=');
        if (equals != std::string::npos)
            pairs.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    }
    return pairs;
}

}  // namespace ink::harness
