#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "harness/row.h"
#include "score/attribution.h"

namespace ink::experiment {

/// Where a method's error goes: counts added up over some rows.
struct CauseTotals {
    std::string method;
    std::int64_t n_pred = 0;
    std::int64_t n_truth = 0;
    std::int64_t unmatched_duplicates = 0;
    std::int64_t false_positives = 0;
    std::int64_t unmatched_truth = 0;
    std::int64_t false_negatives = 0;
    score::CauseCounts causes;
};

/// The totals of each method over its rows that did not fail, in order of first appearance, and of
/// `sampled` last. `none` misses and `oracle` finds everything, so both are left out.
[[nodiscard]] std::vector<CauseTotals> cause_totals(const std::vector<const harness::Row*>& rows);
[[nodiscard]] std::vector<CauseTotals> cause_totals(const std::vector<harness::Row>& rows);

/// A cause's name as words, for legends and headings.
[[nodiscard]] std::string label_of(score::Cause cause);

/// What a cause means, in a phrase.
[[nodiscard]] std::string_view meaning_of(score::Cause cause);

}  // namespace ink::experiment
