#include "summary/comparison.h"

#include <algorithm>
#include <cstdint>

#include "summary/summary_csv.h"

namespace ink::summary {
namespace {

bool has_columns(const core::CsvTable& table, const core::TableInfo& info) {
    return std::ranges::equal(table.columns, info.columns, {}, {}, &core::Column::name);
}

/// Of a table whose lines are of these summaries; those of baselines are empty, and all with fewer
/// than six scenes.
std::vector<double> read_shares(const core::CsvTable& summary) {
    std::vector<double> shares;
    bool has_any = false;
    for (std::size_t i = 0; i < summary.records.size(); ++i) {
        const auto share =
            core::CsvField(summary, i, summary.find("answer_share")).as<std::optional<double>>();
        shares.push_back(share.value_or(0));
        has_any = has_any || share;
    }
    return has_any ? shares : std::vector<double>{};
}

}  // namespace

Comparison compare_methods(const std::vector<harness::Row>& rows, const AnswerRule& rule) {
    Comparison made{rule, summarise(rows)};
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().seed;
    made.differences = all_paired_differences(rows, made.summaries);
    made.shares = answer_shares(made.summaries, rule, seed);
    return made;
}

std::optional<Comparison> read_comparison(const std::vector<harness::Row>& rows,
                                          const AnswerRule& rule,
                                          const core::CsvTable& summary,
                                          const core::CsvTable& differences) {
    Comparison read{rule, summarise(rows)};
    if (!has_columns(summary, summary_table()) || !has_columns(differences, differences_table()) ||
        summary.records.size() != read.summaries.size())
        return std::nullopt;
    read.differences = read_differences(differences);
    read.shares = read_shares(summary);
    return read;
}

}  // namespace ink::summary
