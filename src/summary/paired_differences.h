#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/row.h"
#include "harness/tables/table.h"
#include "score/score.h"
#include "statistics/spread.h"

namespace ink::summary {

/// Two rows of one view: of two methods, or of two runs.
struct RowPair {
    const harness::Row* a = nullptr;
    const harness::Row* b = nullptr;
};

/// Counts at 2 px of both sides of row pairs, summed over the views of each scene, in the
/// alphabetical order of the scenes.
struct PairedScenes {
    std::vector<score::CurveCount> a;
    std::vector<score::CurveCount> b;
    std::vector<std::string> names;  ///< of the scenes

    [[nodiscard]] bool is_empty() const { return a.empty(); }
    /// F over all scenes of either side.
    [[nodiscard]] double f_a() const;
    [[nodiscard]] double f_b() const;
};

/// The scenes of the pairs that both sides have a score for; none if no pair has.
[[nodiscard]] PairedScenes paired_scenes(std::span<const RowPair> pairs);

/// By how much one method's pooled F at 2 px exceeds another's, over the views that both have.
struct PairedDifference {
    std::string a;
    std::string b;
    double difference = 0;  ///< F of a less F of b
    std::optional<statistics::Interval>
        range;  ///< 95 %, paired cluster bootstrap; nothing with one scene
    /// The same for all pairs that were looked at together; nothing if this is the only one.
    std::optional<statistics::Interval> range_of_all = {};

    /// Whether the interval leaves out 0, that of all pairs if there are many: chance in the choice
    /// of scenes, and of the pair, does not explain it.
    [[nodiscard]] bool is_significant() const {
        const auto& decisive = range_of_all ? range_of_all : range;
        return decisive && (decisive->low > 0 || decisive->high < 0);
    }
};

/// The paired difference of `a` over `b`; nothing if they have no view in common.
[[nodiscard]] std::optional<PairedDifference> paired_difference_of(
    const std::vector<harness::Row>& rows, const std::string& a, const std::string& b);

/// The paired differences of `a` over every other method (baselines left out), the best first.
/// `range_of_all` holds for all of them together: `a` against many.
[[nodiscard]] std::vector<PairedDifference> paired_differences_from(
    const std::vector<harness::Row>& rows, const std::string& a);

/// The paired differences of every ordered pair of methods (baselines left out), the best method
/// first: the lines of a matrix. Pairs without a view in common are left out.
///
/// `range` holds by itself, and over many pairs some such leave out 0 by chance; `range_of_all` are
/// the intervals that hold all together (statistics/bootstrap.h).
[[nodiscard]] std::vector<PairedDifference> all_paired_differences(
    const std::vector<harness::Row>& rows);

/// differences.csv: the same as a table of the run folder. No differences give the heading alone.
[[nodiscard]] const harness::TableInfo& differences_table();
[[nodiscard]] std::string differences_csv(const std::vector<PairedDifference>& differences);

/// "+.012 [+.002, +.021]", the interval that of all pairs if there are many; the difference alone
/// where there is none.
[[nodiscard]] std::string format_paired_difference(const PairedDifference& paired);

}  // namespace ink::summary
