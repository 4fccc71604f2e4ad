#include "experiment/run_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/dictionary.h"
#include "harness/rows/side_tables.h"
#include "studies/axis_rows.h"
#include "studies/axis_summary.h"
#include "summary/cost_model.h"
#include "summary/summary_csv.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

/// All lines of a table, below its heading.
std::string joined(const RecordedTable& table,
                   const BlockStore& store,
                   const std::vector<std::size_t>& blocks) {
    std::string text = table.heading + "\n";
    for (const std::size_t block : blocks)
        text += store.lines(block, table.name);
    return text;
}

/// Leaves out lines about cells that rows.csv does not have: of a run that is not finished, the
/// block of a cell's settings may be done, and that of the cell itself not.
void drop_lines_without_cell(std::map<std::string, std::string>& texts) {
    if (!texts.contains("rows.csv")) return;
    const core::CsvTable rows = core::split_csv(texts.at("rows.csv"), "rows.csv");
    const std::size_t cell = rows.find("cell");
    std::set<std::string> cells;
    for (const auto& record : rows.records)
        cells.insert(record[cell]);
    for (auto& [name, text] : texts) {
        const core::CsvTable table = core::split_csv(text, name);
        const std::size_t column = table.find("cell");
        if (name == "rows.csv" || column == table.columns.size()) continue;
        std::string kept = text.substr(0, text.find('\n') + 1);
        for (const auto& record : table.records) {
            if (cells.contains(record[column])) kept += fmt::format("{}\n", fmt::join(record, ","));
        }
        text = std::move(kept);
    }
}

/// Reads what tables hold. Throws core::Error (where = the table's file and the line) for what no
/// such table holds.
RunTables parse_tables(const CsvTables& tables) {
    RunTables run;
    const auto table = [&](const char* name) {
        const auto found = tables.find(name);
        return found == tables.end() ? nullptr : &found->second;
    };
    const core::CsvTable* rows = table("rows.csv");
    if (rows == nullptr) return run;
    std::vector<harness::RowRecord> records = harness::read_rows(*rows);
    if (const auto* csv = table("tolerances.csv")) harness::join_tolerances(*csv, records);
    if (const auto* csv = table("bins.csv")) harness::join_bins(*csv, records);
    if (const auto* csv = table("cost.csv")) harness::join_costs(*csv, records);
    const harness::RowIndex index(records);
    const std::array<std::function<void()>, 2> long_tables = {
        [&] {
            const auto* csv = table("curves.csv");
            if (csv == nullptr) return;
            for (harness::CurveRecord& record : harness::read_curves(*csv, index))
                if (!harness::is_baseline(record.curve.method))
                    run.curves.push_back(std::move(record.curve));
        },
        [&] {
            if (const auto* csv = table("sweep.csv")) run.sweep = harness::read_sweep(*csv, index);
        }};
    core::parallel_for(
        long_tables.size(), core::hardware_threads(), [&](std::size_t i) { long_tables[i](); });
    std::map<std::int64_t, studies::CaseFaults> faults;
    if (const auto* csv = table("stress.csv")) {
        for (const auto& of : studies::read_faults(*csv, index))
            faults[of.row.cell] = of.faults;
    }
    for (harness::RowRecord& record : records) {
        if (record.row.value) run.on_axes.push_back({std::move(record.row), faults[record.cell]});
        if (record.study != harness::Study::compare) continue;
        run.rows.push_back(std::move(record.row));
    }
    return run;
}

}  // namespace

CsvTables split_tables(const std::map<std::string, std::string>& texts, const fs::path& where) {
    CsvTables tables;
    std::vector<std::string> names;
    for (const auto& [name, text] : texts) {
        tables[name];
        names.push_back(name);
    }
    core::parallel_for(names.size(), core::hardware_threads(), [&](std::size_t i) {
        const std::string& name = names[i];
        tables.at(name) = core::split_csv(texts.at(name), (where / name).string());
    });
    return tables;
}

std::vector<harness::Row> rows_of_one_place(std::vector<harness::Row> rows) {
    if (rows.empty()) return rows;
    const auto place_of = [](const harness::Row& row) {
        return std::tuple(row.width, row.height, row.threads);
    };
    const auto first = place_of(rows.front());
    std::erase_if(rows, [&](const harness::Row& row) { return place_of(row) != first; });
    return rows;
}

std::string method_fact(const RunData& run, const std::string& method, std::string_view column) {
    const auto file = run.csv.find("methods.csv");
    if (file == run.csv.end()) return "";
    const core::CsvTable& table = file->second;
    const std::size_t name = table.find("method"), at = table.find(column);
    for (const auto& record : table.records)
        if (at < record.size() && core::unquoted(record[name]) == method)
            return core::unquoted(record[at]);
    return "";
}

RunData read_run(const fs::path& folder) {
    const auto record = read_record(folder);
    if (!record) {
        throw core::Error(
            folder.string(), "there is no run in it", "a folder with a run.toml of inkbench");
    }
    RunData run;
    run.folder = folder;
    run.record = *record;
    const BlockStore store(folder);
    const std::vector<std::size_t> blocks = store.indices();
    std::map<std::string, std::string> texts;
    if (record->state == RunState::unfinished && !blocks.empty()) {
        // Its tables may be older than its blocks, or not there.
        texts = finished_tables(*record, store);
        for (const std::size_t block : blocks)
            if (const auto kept = store.read(block))
                std::erase(run.record.missing_blocks, kept->key);
    } else {
        for (const RecordedTable& table : record->tables) {
            auto text = core::read_whole_file(folder / table.name);
            if (!text) {
                throw core::Error(
                    (folder / table.name).string(), "it cannot be read", "a table of a run folder");
            }
            texts[table.name] = *std::move(text);
        }
        for (const core::TableInfo& table : dictionary()) {
            if (texts.contains(table.file) || table.file == "run.toml") continue;
            if (auto text = core::read_whole_file(folder / table.file))
                texts[table.file] = *std::move(text);
        }
    }
    run.csv = split_tables(texts, folder);
    run.tables = parse_tables(run.csv);
    if (const auto rows = rows_of_one_place(run.tables.rows); !rows.empty())
        run.comparison = summary::compare_methods(rows, record->answer);
    run.finding = studies::stress_finding(studies::summarise_axes(run.tables.on_axes));
    if (!run.record.finding.empty()) run.finding = {run.record.finding, ""};
    return run;
}

std::map<std::string, std::string> finished_tables(const RunRecord& record,
                                                   const BlockStore& store) {
    std::map<std::string, std::string> texts;
    const std::vector<std::size_t> blocks = store.indices();
    for (const RecordedTable& table : record.tables)
        texts[table.name];
    core::parallel_for(record.tables.size(), core::hardware_threads(), [&](std::size_t i) {
        const RecordedTable& table = record.tables[i];
        texts.at(table.name) = joined(table, store, blocks);
    });

    if (blocks.size() < static_cast<std::size_t>(record.blocks)) drop_lines_without_cell(texts);
    const RunTables data = parse_tables(split_tables(texts, store.folder()));
    const summary::CostFit fit =
        record.times ? summary::predict_costs(data.rows, data.sweep) : summary::CostFit{};
    // Over several sizes or numbers of threads no one time of a method means anything.
    if (record.one_place && record.kind == "compare") {
        summary::Comparison comparison = summary::compare_methods(data.rows, record.answer);
        summary::add_curves(data.curves, comparison.summaries);
        texts.merge(summary::comparison_tables(data.rows, comparison));
        if (std::string kinds = summary::kinds_csv(comparison.summaries); !kinds.empty())
            texts["kinds.csv"] = std::move(kinds);
    }
    if (record.kind == "compare")
        texts["unscored.csv"] = summary::unscored_table().file(summary::unscored_cells(data.rows));
    if (fit.cells > 0) {
        texts["cost_fit.csv"] = summary::cost_fit_csv(fit);
        texts["predictions.csv"] = summary::predictions_table().file(fit.predictions);
    }
    if (const auto points = studies::summarise_axes(data.on_axes); !points.empty())
        texts["axis_summary.csv"] = studies::axis_summary_csv(points);
    return texts;
}

}  // namespace ink::experiment
