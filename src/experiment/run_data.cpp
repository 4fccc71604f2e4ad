#include "experiment/run_data.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "experiment/block_store.h"
#include "experiment/dictionary.h"
#include "experiment/run_tables.h"
#include "harness/rows/cost_tables.h"
#include "harness/rows/score_tables.h"
#include "harness/rows/sweep_table.h"
#include "studies/axis_tables.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

summary::Comparison comparison_of(const RunData& run) {
    if (run.tables.rows.empty()) return {};
    RunTables kept;
    kept.rows = run.tables.rows;
    keep_one_place(kept);
    return summary::compare_methods(kept.rows, run.record.answer);
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

void keep_one_place(RunTables& tables) {
    if (tables.rows.empty()) return;
    const harness::Row first = tables.rows.front();
    const auto is_elsewhere = [&](const harness::Row& row) {
        return row.width != first.width || row.height != first.height ||
               row.threads != first.threads;
    };
    std::erase_if(tables.rows, is_elsewhere);
    std::erase_if(tables.sweep, is_elsewhere);
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
        for (FinishedTable& table : finished_tables(*record, store))
            texts[table.name] = std::move(table.text);
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
    run.comparison = comparison_of(run);
    run.finding = studies::stress_finding(studies::summarise_axes(run.tables.on_axes));
    if (!run.record.finding.empty()) run.finding = {run.record.finding, ""};
    return run;
}

}  // namespace ink::experiment
