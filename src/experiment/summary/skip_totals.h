#pragma once

#include <array>
#include <string>
#include <vector>

#include "harness/row.h"
#include "raster/skips.h"

namespace ink::experiment {

/// How much of one skip's work was left undone over some rows.
struct SkipTotal {
    raster::SkipCount count;  ///< summed: large cells weigh more
    const harness::Row* most =
        nullptr;  ///< where the share was largest; null if it applied nowhere
};

/// What one method left undone. It points into the rows.
struct SkipTotals {
    std::string method;
    std::array<SkipTotal, raster::kSkipCount> of_skip;
};

/// The share that was left undone, 0..1; 0 where there was nothing to do.
[[nodiscard]] double share_of(const raster::SkipCount& count);

/// The totals of each method over its rows that did not fail, in order of first appearance; methods
/// whose rows count nothing (baselines) are left out. Of equal shares the first row stays.
[[nodiscard]] std::vector<SkipTotals> skip_totals(const std::vector<harness::Row>& rows);

}  // namespace ink::experiment
