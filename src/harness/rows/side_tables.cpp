#include "harness/rows/side_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "harness/cells/cell.h"
#include "harness/rows/row_table.h"

namespace ink::harness {
namespace {

template <class At>
SideTable<CountsAt<At>> counts_table(const std::string& file,
                                     const std::string& doc,
                                     core::Column at) {
    using C = score::CurveCount;
    SideTable<CountsAt<At>> table(file, doc);
    table.add(std::move(at), &CountsAt<At>::at);
    const auto counts = table.part(&CountsAt<At>::counts);
    counts.add({"k", "px", "one-to-one matches"}, &C::k);
    counts.add({"n_pred", "px", "drawn pixels after thinning that count"}, &C::n_pred);
    counts.add({"n_truth", "px", "true pixels"}, &C::n_truth);
    return table;
}

void add_declared(const core::PartOf<CostFacts>& facts) {
    using C = method::Cost;
    using B = method::PixelBytes;
    const auto declared = facts.part(&CostFacts::declared);
    declared.add(
        {"passes", "", "over the triangles that the method declares; 0: it declares nothing"},
        &C::passes);
    declared.add({"interpolants", "", "planes set up per triangle, beside that of depth"},
                 &C::interpolants);
    declared.add({"values_per_vertex", "", "numbers computed at a vertex to be interpolated"},
                 &C::values_per_vertex);
    declared.add({"shares_vertices", "", "false: every triangle has three of its own"},
                 &C::shares_vertices);
    const auto fill = declared.part(&C::fill);
    fill.add({"fill_bytes_read", "B/px", "per covered pixel of a triangle, hidden ones too"},
             &B::read);
    fill.add({"fill_bytes_written", "B/px", "the same"}, &B::written);
    const auto filter = declared.part(&C::filter);
    filter.add({"filter_bytes_read", "B/px", "per pixel of the frame, empty ones too"}, &B::read);
    filter.add({"filter_bytes_written", "B/px", "the same"}, &B::written);
    declared.add({"buffer_bytes_per_px", "B/px", "cleared once a frame, depth included"},
                 &C::buffer_bytes_per_px);
}

void add_frame(const core::PartOf<CostFacts>& facts) {
    using F = FrameCounts;
    const auto frame = facts.part(&CostFacts::frame);
    frame.add({"frame_vertices", "", "of the meshes, counted once per instance"}, &F::vertices);
    frame.add({"frame_triangles", "", "over all instances, those outside the image too"},
              &F::triangles);
    frame.add({"frame_covered_px", "px", "area in the image summed over all triangles"},
              &F::covered_px);
    frame.add({"frame_px", "px", "width times height"}, &F::frame_px);
}

RowTable make_cost_table() {
    RowTable table("cost.csv",
                   "A line per cell of a method: what it declares of its work, and what the view "
                   "asks of it.");
    table.add({"cell", "", "of rows.csv"}, &RowRecord::cell);
    const auto facts = table.part(&RowRecord::row).part(&Row::cost);
    add_declared(facts);
    add_frame(facts);
    return table;
}

constexpr std::string_view kSweepFile = "sweep.csv";
constexpr const char* kSweepDoc =
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

SettingTable make_sweep_table(const SweepColumns& swept) {
    SettingTable table{std::string(kSweepFile), kSweepDoc};
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
        throw core::Error(std::string(kSweepFile),
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

const SideTable<CountsAt<int>>& curves_table() {
    static const auto kTable = counts_table<int>(
        "curves.csv",
        "99 lines per scored cell: its counts within 2 px at every threshold.",
        {"threshold",
         "1/100",
         "of the full edge response: a pixel is on where 100 S >= 255 threshold"});
    return kTable;
}

const SideTable<CountsAt<double>>& tolerances_table() {
    static const auto kTable = counts_table<double>(
        "tolerances.csv",
        "A line per scored cell and tolerance: its counts at its own threshold.",
        {"tolerance_px", "px", "how far a match may be, centre to centre"});
    return kTable;
}

const SideTable<BinCount>& bins_table() {
    static const auto kTable = [] {
        SideTable<BinCount> table(
            "bins.csv",
            "A line per cell and bin of a property of true lines: how much of it was found within "
            "2 px, by a matching of its own. Bins without a true pixel are left out.");
        std::vector<std::string> names, docs;
        for (const LineAttribute& a : line_attributes()) {
            names.push_back(a.name);
            docs.push_back(fmt::format("{}: {}", a.name, a.doc));
        }
        table.add_named({"attribute", "", fmt::format("{}", fmt::join(docs, "; "))},
                        &BinCount::attribute,
                        names);
        table.add({"low", "of attribute", "the bin begins here; inf: the sky behind"},
                  &BinCount::low);
        table.add({"high", "of attribute", "and ends before here; the last holds its end"},
                  &BinCount::high);
        table.add({"k", "px", "one-to-one matches"}, &BinCount::k);
        table.add({"n_truth", "px", "true pixels"}, &BinCount::n_truth);
        return table;
    }();
    return kTable;
}

std::string curve_lines(std::int64_t cell, const std::array<score::CurveCount, 99>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += curves_table().line(cell, {static_cast<int>(i + 1), counts[i]});
    return lines;
}

std::vector<CurveRecord> read_curves(const core::CsvTable& csv, const RowIndex& rows) {
    const auto read = curves_table().read(csv);
    std::vector<CurveRecord> records;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const std::size_t at = i % 99;
        if (read[i].at != static_cast<int>(at + 1))
            core::CsvField(csv, i, 1).refuse(
                fmt::format("{}: 1 to 99 in a row for every cell", at + 1));
        if (at == 0) {
            const Row& row = rows.find(core::CsvField(csv, i, 0)).row;
            records.push_back({read[i].cell, {row.method, {}}});
        }
        if (read[i].cell != records.back().cell)
            core::CsvField(csv, i, 0).refuse(fmt::format("cell {}, up to 99", records.back().cell));
        records.back().curve.counts[at] = read[i].counts;
    }
    if (read.size() % 99 != 0)
        core::CsvField(csv, read.size() - 1, 1).refuse("99 on the last line");
    return records;
}

std::string tolerance_lines(std::int64_t cell, const std::vector<score::CurveCount>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += tolerances_table().line(cell, {kTolerances_px.at(i), counts[i]});
    return lines;
}

void join_tolerances(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    const IndexOf<RowRecord> cells(rows);
    const auto read = tolerances_table().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = cells.find(core::CsvField(csv, i, 0)).row;
        if (row.tolerance_sweep.size() == kTolerances_px.size())
            core::CsvField(csv, i, 0).refuse("every tolerance once");
        const double wanted_px = kTolerances_px[row.tolerance_sweep.size()];
        if (read[i].at != wanted_px)
            core::CsvField(csv, i, 1).refuse(
                fmt::format("{}, next of {}", wanted_px, fmt::join(kTolerances_px, ", ")));
        row.tolerance_sweep.push_back(read[i].counts);
    }
}

std::string bin_lines(std::int64_t cell, const std::vector<BinCount>& counts) {
    std::string lines;
    for (const BinCount& bin : counts)
        lines += bins_table().line(cell, bin);
    return lines;
}

void join_bins(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    const IndexOf<RowRecord> cells(rows);
    const auto read = bins_table().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = cells.find(core::CsvField(csv, i, 0)).row;
        if (!row.is_scored()) core::CsvField(csv, i, 0).refuse("a cell whose row has a score");
        row.bins.push_back(read[i]);
    }
}

const RowTable& cost_table() {
    static const RowTable kTable = make_cost_table();
    return kTable;
}

std::string cost_line(std::int64_t cell, const Row& row) {
    return row.cost ? cost_table().line({cell, Study::compare, row}) : "";
}

void join_costs(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    core::check_columns(csv, cost_table());
    const IndexOf<RowRecord> cells(rows);
    for (std::size_t i = 0; i < csv.records.size(); ++i) {
        RowRecord& record = cells.find(core::CsvField(csv, i, 0));
        if (record.row.cost) core::CsvField(csv, i, 0).refuse("every cell once");
        cost_table().read_into(csv, i, record);
    }
}

core::TableInfo sweep_table(const SweepColumns& swept) {
    return make_sweep_table(swept).info();
}

std::string sweep_line(std::int64_t cell, int setting, const SweepColumns& swept, const Row& row) {
    return make_sweep_table(swept).line({{cell, Study::compare, row}, setting});
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
    const SettingTable table = make_sweep_table(sweep_columns(csv));
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
