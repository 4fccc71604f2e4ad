#include "harness/tables/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

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

/// A setting with its number.
struct Setting {
    RowRecord of;
    int number = 0;
};
using SettingTable = TableOf<Setting>;

void add(SettingTable& table, RowTable::Field field) {
    table.add(
        std::move(field.column),
        [write = std::move(field.write)](const Setting& s) { return write(s.of); },
        [read = std::move(field.read)](const CsvField& text, Setting& s) { read(text, s.of); });
}

std::string value_of(const std::string& params, const std::string& key) {
    for (const auto& [name, value] : split_params(params)) {
        if (name == key) return value;
    }
    return "";
}

/// The parameter's value alone goes into `params` when it is read: read_sweep adds the rest.
void add_parameter(SettingTable& table, const std::string& key) {
    table.add(
        {key, "", "the parameter of this name; empty if the method has none"},
        [key](const Setting& s) { return csv_field(value_of(s.of.row.params, key)); },
        [key](const CsvField& field, Setting& s) {
            if (field.is_empty()) return;
            std::string& params = s.of.row.params;
            params += fmt::format("{}{}={}", params.empty() ? "" : ";", key, field.text());
        });
}

SettingTable make_table(const std::vector<std::string>& swept) {
    SettingTable table{std::string(kFile), kDoc};
    table.add(
        {"cell", "", "of rows.csv: this method at its own settings on this view"},
        [](auto& s) -> auto& { return s.of.cell; });
    table.add(
        {"setting", "", "counted from 1 within the cell"},
        [](auto& s) -> auto& { return s.number; });
    add(table, row_fields().field("status"));
    for (const std::string& key : swept)
        add_parameter(table, key);
    for (const char* name : kNumbers)
        add(table, row_fields().field(name));
    for (const RowTable::Field& field : cost_fields())
        add(table, field);
    std::set<std::string> names;
    for (const Column& column : table.info().columns) {
        if (names.insert(column.name).second) continue;
        throw core::Error(std::string(kFile),
                          fmt::format("a parameter is called {}, as a column is", column.name),
                          "parameters with other names");
    }
    return table;
}

/// The whole parameters of a setting: those of its cell, with what it changes.
std::string with_changes(const std::string& own, const std::string& changes) {
    const auto changed = split_params(changes);
    std::string params;
    for (const auto& [key, value] : split_params(own)) {
        const auto at = std::find_if(
            changed.begin(), changed.end(), [&](const auto& c) { return c.first == key; });
        params += fmt::format(
            "{}{}={}", params.empty() ? "" : ";", key, at == changed.end() ? value : at->second);
    }
    return params;
}

/// What of a cell's row holds at every setting too.
Row place_of_setting(const Row& own) {
    Row row;
    row.method = own.method;
    row.scene = own.scene;
    row.view = own.view;
    row.split = own.split;
    row.width = own.width;
    row.height = own.height;
    row.threads = own.threads;
    row.seed = own.seed;
    row.skips_off = own.skips_off;
    row.truth_merged_px = own.truth_merged_px;
    row.crowded_share = own.crowded_share;
    row.triangles = own.triangles;
    row.weld_epsilon = own.weld_epsilon;
    row.contour_sky_px = own.contour_sky_px;
    row.contour_other_px = own.contour_other_px;
    row.contour_self_px = own.contour_self_px;
    row.reference_disagreement = own.reference_disagreement;
    row.crosscheck_px = own.crosscheck_px;
    row.provenance = own.provenance;
    return row;
}

/// Moves what a line holds into the row of its place.
Row complete_row(const Row& own, Row&& read) {
    Row row = place_of_setting(own);
    row.params = with_changes(own.params, read.params);
    if (const std::string own_threshold = value_of(read.params, "threshold");
        !own_threshold.empty())
        row.threshold = std::stoi(own_threshold);
    row.status = std::move(read.status);
    row.f_2px = read.f_2px;
    row.precision_2px = read.precision_2px;
    row.recall_2px = read.recall_2px;
    row.k_2px = read.k_2px;
    row.n_pred = read.n_pred;
    row.n_truth = read.n_truth;
    row.truth_px = read.n_truth;
    row.unmatched_duplicates = read.unmatched_duplicates;
    row.false_positives = read.false_positives;
    row.unmatched_truth = read.unmatched_truth;
    row.false_negatives = read.false_negatives;
    row.prepare_ns = read.prepare_ns;
    row.pose_ns = read.pose_ns;
    row.draw_ns = read.draw_ns;
    row.draw_ns_q25 = read.draw_ns_q25;
    row.draw_ns_q75 = read.draw_ns_q75;
    row.draw_ns_min = read.draw_ns_min;
    row.draw_n = read.draw_n;
    row.bytes_per_px = read.bytes_per_px;
    row.image_hash = std::move(read.image_hash);
    row.cost = read.cost;
    row.predicted_ns = read.predicted_ns;
    row.cost_residual = read.cost_residual;
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

std::vector<SweepRecord> read_sweep(const CsvTable& csv, const RowIndex& rows) {
    std::vector<Setting> settings = make_table(swept_parameters(csv)).read(csv);
    std::vector<SweepRecord> records;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const RowRecord& own = rows.find(CsvField(csv, i, 0));
        records.push_back(
            {own.cell, settings[i].number, complete_row(own.row, std::move(settings[i].of.row))});
    }
    return records;
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

std::vector<std::string> changed_parameters(const std::string& own,
                                            const std::vector<std::string>& settings) {
    std::set<std::string> changed;
    for (const std::string& setting : settings) {
        for (const auto& [key, value] : split_params(setting)) {
            if (value_of(own, key) != value) changed.insert(key);
        }
    }
    return {changed.begin(), changed.end()};
}

}  // namespace ink::harness
