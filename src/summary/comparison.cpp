#include "summary/comparison.h"

#include <algorithm>
#include <cstdint>

#include "summary/summary_csv.h"

namespace ink::summary {
namespace {

/// Null if it is not there, or has other columns.
const core::CsvTable* find_table(const std::map<std::string, core::CsvTable>& tables,
                                 const core::TableInfo& info) {
    const auto found = tables.find(info.file);
    const bool is_known =
        found != tables.end() &&
        std::ranges::equal(found->second.columns, info.columns, {}, {}, &core::Column::name);
    return is_known ? &found->second : nullptr;
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

Measure Comparison::measure() const {
    const auto is_soft = [](const MethodSummary& s) { return s.measure() == Measure::soft_f; };
    return std::ranges::any_of(summaries, is_soft) ? Measure::soft_f : Measure::f_2px;
}

Comparison compare_methods(const std::vector<harness::Row>& rows, const AnswerRule& rule) {
    Comparison made{rule, summarise(rows)};
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().seed;
    made.differences = all_paired_differences(rows, made.summaries, Measure::f_2px);
    made.soft_differences = all_paired_differences(rows, made.summaries, Measure::soft_f);
    made.shares = answer_shares(made.summaries, rule, seed);
    return made;
}

std::optional<Comparison> read_comparison(const std::vector<harness::Row>& rows,
                                          const AnswerRule& rule,
                                          const std::map<std::string, core::CsvTable>& tables) {
    Comparison read{rule, summarise(rows)};
    const bool is_soft = read.measure() == Measure::soft_f;
    const auto* const summary = find_table(tables, summary_table(is_soft));
    const auto* const differences = find_table(tables, differences_table());
    const auto* const soft = find_table(tables, soft_differences_table());
    if (summary == nullptr || differences == nullptr || (is_soft && soft == nullptr) ||
        summary->records.size() != read.summaries.size())
        return std::nullopt;
    read.differences = read_differences(*differences);
    if (is_soft) read.soft_differences = read_differences(*soft);
    read.shares = read_shares(*summary);
    return read;
}

std::map<std::string, std::string> comparison_tables(const std::vector<harness::Row>& rows,
                                                     const Comparison& comparison) {
    std::map<std::string, std::string> tables = {
        {"summary.csv", summary_csv(rows, comparison)},
        {"differences.csv", differences_csv(comparison.differences)}};
    if (comparison.measure() == Measure::soft_f)
        tables["soft_differences.csv"] = differences_csv(comparison.soft_differences);
    return tables;
}

}  // namespace ink::summary
