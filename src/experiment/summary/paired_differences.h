#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/row.h"
#include "harness/tables/table.h"
#include "statistics/spread.h"

namespace ink::experiment {

/// By how much one method's pooled F at 2 px exceeds another's, over the views that both have.
struct PairedDifference {
    std::string a;
    std::string b;
    double difference = 0;  ///< F of a less F of b
    std::optional<statistics::Interval>
        range;  ///< 95 %, paired cluster bootstrap; nothing with one scene

    /// Whether the interval leaves out 0: chance in the choice of scenes does not explain it.
    [[nodiscard]] bool is_significant() const {
        return range && (range->low > 0 || range->high < 0);
    }
};

/// The paired difference of `a` over `b`; nothing if they have no view in common.
[[nodiscard]] std::optional<PairedDifference> paired_difference_of(
    const std::vector<harness::Row>& rows, const std::string& a, const std::string& b);

/// The paired differences of every ordered pair of methods (baselines left out), the best method
/// first: the lines of a matrix. Pairs without a view in common are left out.
///
/// Intervals are each 95 %; over many pairs some leave out 0 by chance alone (no correction is
/// made).
[[nodiscard]] std::vector<PairedDifference> all_paired_differences(
    const std::vector<harness::Row>& rows);

/// differences.csv: the same as a table of the run folder. No differences give the heading alone.
[[nodiscard]] const harness::TableInfo& differences_table();
[[nodiscard]] std::string differences_csv(const std::vector<PairedDifference>& differences);

/// "+.012 [+.002, +.021]"; the difference alone where there is no interval.
[[nodiscard]] std::string format_paired_difference(const PairedDifference& paired);

}  // namespace ink::experiment
