#pragma once

#include <span>
#include <string>
#include <vector>

#include "harness/row.h"
#include "score/score.h"

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

}  // namespace ink::summary
