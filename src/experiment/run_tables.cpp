#include "experiment/run_tables.h"

#include <algorithm>
#include <map>

#include "experiment/run_data.h"
#include "experiment/summary/cost_model.h"
#include "experiment/summary/paired_differences.h"
#include "experiment/summary/stress_summary.h"
#include "experiment/summary/summary_csv.h"
#include "experiment/summary/unscored.h"

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

}  // namespace

std::vector<FinishedTable> finished_tables(const RunRecord& record, const BlockStore& store) {
    std::map<std::string, std::string> texts;
    const std::vector<std::size_t> blocks = store.indices();
    for (const RecordedTable& table : record.tables)
        texts[table.name] = joined(table, store, blocks);

    RunTables data = parse_tables(texts, store.folder().string());
    const CostFit fit = record.times ? predict_costs(data.rows, data.sweep) : CostFit{};
    if (fit.cells > 0) write_costs(data, texts);
    std::vector<FinishedTable> tables;
    for (const RecordedTable& table : record.tables)
        tables.push_back({table.name, std::move(texts.at(table.name))});
    // Over several sizes or numbers of threads no one time of a method means anything.
    if (record.one_place && record.kind == "compare") {
        tables.push_back({"summary.csv", summary_csv(data.rows, data.curves)});
        tables.push_back({"differences.csv", differences_csv(all_paired_differences(data.rows))});
    }
    if (record.kind == "compare")
        tables.push_back({"unscored.csv", unscored_csv(unscored_cells(data.rows))});
    if (fit.cells > 0) tables.push_back({"cost_fit.csv", cost_fit_csv(fit)});
    if (!data.stress.empty()) {
        const std::uint64_t seed = data.stress.front().row.seed;
        tables.push_back(
            {"stress_summary.csv", stress_summary_csv(summarise_stress(data.stress, seed))});
        tables.push_back({"stress_axes.csv", stress_axes_csv(data.stress)});
    }
    return tables;
}

}  // namespace ink::experiment
