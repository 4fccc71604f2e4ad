#pragma once

#include <string>
#include <vector>

#include "harness/row.h"
#include "summary/paired_differences.h"

namespace ink::experiment {

/// The cells of two runs, paired: the same method on the same view.
struct CellPairs {
    std::vector<summary::RowPair> paired;    ///< in the order of the first run
    std::vector<const harness::Row*> gone;   ///< of the first run alone
    std::vector<const harness::Row*> added;  ///< of the second run alone
};

/// Pairs the rows of two runs by method, scene, view, size, threads and parameters.
///
/// What is left over is paired without the parameters, where each run has just one such cell left:
/// its method was asked with another setting. Borrows the rows; empty runs give no pairs.
[[nodiscard]] CellPairs pair_cells(const std::vector<harness::Row>& a,
                                   const std::vector<harness::Row>& b);

/// The parameters that differ between two texts "key=value;key=value": "threshold 20 -> 25", joined
/// by ", ", in alphabetical order; "" if none does. A side that lacks the key has "-".
[[nodiscard]] std::string changed_parameters(const std::string& a, const std::string& b);

}  // namespace ink::experiment
