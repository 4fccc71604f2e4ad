#include "harness/rows/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "harness/cells/cell.h"
#include "harness/rows/cost_tables.h"
#include "harness/rows/row_parts.h"

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
constexpr const char* kNumbers[] = {
    "f_2px",           "precision_2px",   "recall_2px",           "k_2px",
    "n_pred",          "n_truth",         "unmatched_duplicates", "false_positives",
    "unmatched_truth", "false_negatives", "prepare_ns",           "pose_ns",
    "draw_ns",         "draw_ns_median",  "draw_ns_q75",          "draw_ns_min",
    "draw_n",          "draw_wall_ns",    "time_doubt",           "bytes_per_px",
    "image_hash"};

/// A setting: the row of its cell, with what the setting changes.
struct SettingRow : RowRecord {
    int number = 0;
};
using SettingTable = core::TableOf<SettingRow>;

void add_parameter(SettingTable& table, const std::string& key) {
    table.add(
        {key, "", "the parameter of this name; empty if the method has none"},
        [key](const SettingRow& s) {
            const core::ParamValues params = split_params(s.row.params);
            const auto own = params.find(key);
            return own == params.end() ? "" : core::csv_field(own->second);
        },
        [key](const core::CsvField& field, SettingRow& s) {
            if (field.is_empty()) return;
            core::ParamValues params = split_params(s.row.params);
            if (const auto own = params.find(key); own != params.end()) own->second = field.text();
            s.row.params = join_params(params);
            if (key == "threshold") field.read(s.row.threshold);
        });
}

SettingTable make_table(const SweepColumns& swept) {
    SettingTable table{std::string(kFile), kDoc};
    table.add({"cell", "", "of rows.csv: this method at its own settings on this view"},
              &SettingRow::cell);
    table.add({"setting", "", "counted from 1 within the cell"}, &SettingRow::number);
    table.add_like(rows_table(), "status");
    for (const std::string& key : swept.parameters)
        add_parameter(table, key);
    for (const char* name : kNumbers)
        table.add_like(rows_table(), name);
    if (swept.has_ink) add_ink_columns(table.part(&SettingRow::row).part(&Row::soft));
    for (const core::Column& column : cost_table().info().columns)
        if (column.name != "cell") table.add_like(cost_table(), column.name);
    std::set<std::string> names;
    for (const core::Column& column : table.info().columns) {
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

core::TableInfo sweep_table(const SweepColumns& swept) {
    return make_table(swept).info();
}

std::string sweep_line(std::int64_t cell, int setting, const SweepColumns& swept, const Row& row) {
    return make_table(swept).line({{cell, Study::compare, row}, setting});
}

SweepColumns sweep_columns(const core::CsvTable& csv) {
    const std::size_t first = csv.find("status") + 1;
    const std::size_t end = csv.find(kNumbers[0]);
    SweepColumns swept{.parameters = {}, .has_ink = csv.find("soft_f") < csv.columns.size()};
    for (std::size_t i = first; i < end && i < csv.columns.size(); ++i)
        swept.parameters.push_back(core::unquoted(csv.columns[i]));
    return swept;
}

std::vector<Row> read_sweep(const core::CsvTable& csv, const RowIndex& own) {
    const SettingTable table = make_table(sweep_columns(csv));
    core::check_columns(csv, table.info());
    std::vector<Row> rows;
    for (std::size_t i = 0; i < csv.records.size(); ++i) {
        SettingRow setting;
        setting.row = place_of_setting(own.find(core::CsvField(csv, i, 0)).row);
        table.read_into(csv, i, setting);
        setting.row.truth_px = setting.row.n_truth;
        setting.row.setting = setting.number;
        rows.push_back(std::move(setting.row));
    }
    return rows;
}

core::ParamValues split_params(const std::string& params) {
    core::ParamValues values;
    std::istringstream stream(params);
    for (std::string part; std::getline(stream, part, ';');) {
        const auto equals = part.find('=');
        if (equals != std::string::npos) values[part.substr(0, equals)] = part.substr(equals + 1);
    }
    return values;
}

}  // namespace ink::harness
