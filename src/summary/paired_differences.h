#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/tables/table_of.h"
#include "harness/rows/row.h"
#include "score/score.h"
#include "statistics/spread.h"

namespace ink::summary {

struct MethodSummary;
enum class Measure;

/// Two rows of one view: of two methods, or of two runs.
struct RowPair {
    const harness::Row* a = nullptr;
    const harness::Row* b = nullptr;
};

/// Counts of both sides of row pairs, summed over the views of each scene, in the
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
[[nodiscard]] PairedScenes paired_scenes(std::span<const RowPair> pairs, Measure measure);

/// By how much one method's pooled F exceeds another's, over the views that both have.
struct PairedDifference {
    std::string a;
    std::string b;
    double difference = 0;  ///< F of a less F of b
    std::optional<statistics::Interval>
        range;  ///< 95 %, paired cluster bootstrap; nothing with fewer than six scenes
    /// The same for all pairs that were looked at together.
    std::optional<statistics::Interval> range_of_all = {};
    int scenes = 0;  ///< that both have views of
    int better = 0;  ///< of these, on which a's F is higher,
    int worse = 0;   ///< and on which it is lower

    /// Whether one leads: the interval of all pairs leaves out 0. Chance in the choice of scenes,
    /// and of the pair, does not explain it.
    [[nodiscard]] bool is_significant() const {
        const auto& decisive = range_of_all ? range_of_all : range;
        return decisive && (decisive->low > 0 || decisive->high < 0);
    }
};

/// The paired differences of every ordered pair of methods (baselines left out), the best method
/// first: the lines of a matrix. Pairs without a view in common are left out.
///
/// `range` holds by itself, and over many pairs some such leave out 0 by chance; `range_of_all` are
/// the intervals that are to hold all together (statistics/simultaneous.h).
[[nodiscard]] std::vector<PairedDifference> all_paired_differences(
    const std::vector<harness::Row>& rows,
    const std::vector<MethodSummary>& summaries,
    Measure measure);

/// differences.csv and, of soft F, soft_differences.csv: the same as a table of the run folder. No
/// differences give the heading alone.
[[nodiscard]] const core::TableOf<PairedDifference>& differences_table();
[[nodiscard]] core::TableInfo soft_differences_table();

/// "+.012 [+.002, +.021]", the interval of the pair by itself; the difference alone
/// where there is none. `has_zeros`: "+0.012 [+0.002, +0.021]".
[[nodiscard]] std::string format_paired_difference(const PairedDifference& paired,
                                                   bool has_zeros = false);

}  // namespace ink::summary
