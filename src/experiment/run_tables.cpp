#include "experiment/run_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/parallel.h"
#include "core/tables/csv_table.h"
#include "experiment/run_data.h"
#include "studies/axis_summary.h"
#include "summary/cost_model.h"
#include "summary/summary_csv.h"

namespace ink::experiment {
namespace {

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

}  // namespace

std::vector<FinishedTable> finished_tables(const RunRecord& record, const BlockStore& store) {
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
    std::vector<FinishedTable> tables;
    for (const RecordedTable& table : record.tables)
        tables.push_back({table.name, std::move(texts.at(table.name))});
    // Over several sizes or numbers of threads no one time of a method means anything.
    if (record.one_place && record.kind == "compare") {
        summary::Comparison comparison = summary::compare_methods(data.rows, record.answer);
        summary::add_curves(data.curves, comparison.summaries);
        for (auto& [name, text] : summary::comparison_tables(data.rows, comparison))
            tables.push_back({name, std::move(text)});
        if (std::string kinds = summary::kinds_csv(comparison.summaries); !kinds.empty())
            tables.push_back({"kinds.csv", std::move(kinds)});
    }
    if (record.kind == "compare")
        tables.push_back(
            {"unscored.csv", summary::unscored_csv(summary::unscored_cells(data.rows))});
    if (fit.cells > 0) {
        tables.push_back({"cost_fit.csv", summary::cost_fit_csv(fit)});
        tables.push_back({"predictions.csv", summary::predictions_csv(fit)});
    }
    if (const auto points = studies::summarise_axes(data.on_axes); !points.empty())
        tables.push_back({"axis_summary.csv", studies::axis_summary_csv(points)});
    return tables;
}

}  // namespace ink::experiment
