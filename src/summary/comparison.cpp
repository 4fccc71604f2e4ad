#include "summary/comparison.h"

#include <algorithm>
#include <cstdint>

#include "summary/summary_csv.h"

namespace ink::summary {

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
