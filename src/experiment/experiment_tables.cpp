#include "experiment/experiment_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/cost_facts.h"
#include "experiment/cost_model.h"
#include "experiment/stress_summary.h"
#include "experiment/summary_csv.h"
#include "harness/csv_table.h"
#include "harness/row_reader.h"

namespace ink::experiment {
namespace {

/// All lines of a table, without a heading.
std::string lines_of(const std::vector<KeptBlock>& blocks, const std::string& table) {
    std::string lines;
    for (const KeptBlock& block : blocks) {
        const auto found = block.result.lines.find(table);
        if (found != block.result.lines.end()) lines += found->second;
    }
    return lines;
}

/// A table of rows with what the cost model is made from.
struct RowsTable {
    harness::CsvTable csv;
    std::vector<harness::Row> rows;
};

RowsTable read_table(const std::string& text, const std::string& facts, const std::string& name) {
    RowsTable table{harness::split_csv(text, name), {}};
    table.rows = harness::read_rows(table.csv, name);
    std::size_t at = 0;
    for (harness::Row& row : table.rows) {
        const auto end = facts.find('\n', at);
        if (end == std::string::npos) {
            throw core::Error(name, "the facts of a row are missing", "an unchanged file");
        }
        row.cost = read_cost_facts(facts.substr(at, end - at), name);
        at = end + 1;
    }
    return table;
}

/// Writes what was predicted over the fields, so that no other field changes a byte.
std::string with_predictions(RowsTable& table) {
    const std::size_t predicted = table.csv.find("predicted_ns");
    const std::size_t residual = table.csv.find("cost_residual");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const harness::Row& row = table.rows[i];
        if (!row.predicted_ns || !row.cost_residual) continue;
        table.csv.records[i].at(predicted) = fmt::format("{}", *row.predicted_ns);
        table.csv.records[i].at(residual) = fmt::format("{}", *row.cost_residual);
    }
    return harness::join_csv(table.csv);
}

FinishedTable* find(std::vector<FinishedTable>& tables, const std::string& name) {
    const auto found = std::find_if(
        tables.begin(), tables.end(), [&](const FinishedTable& t) { return t.name == name; });
    return found == tables.end() ? nullptr : &*found;
}

void predict(const std::vector<KeptBlock>& blocks, std::vector<FinishedTable>& tables) {
    FinishedTable* rows = find(tables, "rows.csv");
    FinishedTable* sweep = find(tables, "sweep.csv");
    if (rows == nullptr) return;
    const auto read = [&](FinishedTable* table) {
        if (table == nullptr) return RowsTable{};
        return read_table(table->text, lines_of(blocks, facts_table(table->name)), table->name);
    };
    RowsTable of_rows = read(rows);
    RowsTable of_sweep = read(sweep);
    if (predict_costs(of_rows.rows, of_sweep.rows).cells == 0) return;
    rows->text = with_predictions(of_rows);
    if (sweep != nullptr) sweep->text = with_predictions(of_sweep);
}

/// What the rows say of each method; curves are there where they were asked for.
std::string summary_of(std::vector<FinishedTable>& tables) {
    const auto read = [&](const char* name) {
        const FinishedTable* table = find(tables, name);
        return table == nullptr ? harness::CsvTable{} : harness::split_csv(table->text, name);
    };
    const std::vector<harness::Row> rows = harness::read_rows(read("rows.csv"), "rows.csv");
    return summary_csv(rows, harness::read_curves(read("curves.csv"), rows, "curves.csv"));
}

/// The rows of stress.csv with their places on the axes and their counts.
std::vector<studies::StressRow> read_stress_rows(const harness::CsvTable& table,
                                                 const std::string& where) {
    std::vector<harness::Row> rows = harness::read_rows(table, where);
    const auto of = [&table](std::size_t i, const char* column) {
        return harness::unquoted(table.records[i].at(table.find(column)));
    };
    std::vector<studies::StressRow> stressed;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        stressed.push_back({of(i, "axis"), std::stod(of(i, "value")), of(i, "unit"), rows[i], {}});
        studies::StressCounts& counts = stressed.back().counts;
        counts.non_finite = std::stoll(of(i, "non_finite"));
        counts.overflow = std::stoll(of(i, "overflow"));
        counts.lost = std::stoll(of(i, "lost_cell"));
        counts.differing = std::stoll(of(i, "differing"));
    }
    return stressed;
}

std::string stress_summary_of(const FinishedTable& table) {
    const auto rows = read_stress_rows(harness::split_csv(table.text, table.name), table.name);
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().row.seed;
    return stress_summary_csv(summarise_stress(rows, seed));
}

}  // namespace

std::vector<FinishedTable> finished_tables(const PlanRecord& record,
                                           const std::vector<KeptBlock>& blocks) {
    std::vector<FinishedTable> tables;
    for (const PlannedTable& table : record.tables) {
        std::string lines = lines_of(blocks, table.name);
        if (!record.times) lines = harness::without_times(table.heading, lines);
        tables.push_back({table.name, table.heading + "\n" + lines});
    }
    if (record.times) predict(blocks, tables);
    // Over several sizes or numbers of threads no one time of a method means anything.
    if (record.one_place && find(tables, "rows.csv") != nullptr) {
        tables.push_back({"summary.csv", summary_of(tables)});
    }
    if (const FinishedTable* stress = find(tables, "stress.csv"); stress != nullptr) {
        tables.push_back({"stress_summary.csv", stress_summary_of(*stress)});
    }
    return tables;
}

RunOutcome finish_run(const BlockStore& store,
                      PlanRecord record,
                      const std::vector<KeptBlock>& blocks) {
    RunOutcome outcome;
    for (const FinishedTable& table : finished_tables(record, blocks)) {
        core::write_whole_file(store.folder() / table.name, table.text);
        outcome.tables.push_back(store.folder() / table.name);
    }
    for (const KeptBlock& block : blocks) {
        outcome.faults.insert(
            outcome.faults.end(), block.result.faults.begin(), block.result.faults.end());
    }
    if (outcome.faults.empty()) {
        record.is_finished = true;
        store.write_plan(record);
        store.clear();
    }
    return outcome;
}

}  // namespace ink::experiment
