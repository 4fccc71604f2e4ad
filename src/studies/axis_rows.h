#pragma once

#include <vector>

#include "harness/cells/view_cells.h"
#include "studies/axis.h"

namespace ink::studies {

/// A cell of an axis: its row, and what must not happen in it.
struct AxisRow {
    harness::Row row;
    CaseFaults faults = {};
};

/// Draws one case of an axis with every configuration, and scores it within 2 px, views with most
/// of their lines too dense to score, too: a row per configuration, then the baselines.
///
/// A method that throws is a row whose status says so. Nothing is timed, and no truth is held
/// against the cross-check: rows are the same bytes on every machine.
[[nodiscard]] std::vector<AxisRow> axis_rows(const Case& one,
                                             const std::vector<method::MethodConfig>& configs,
                                             const harness::CellOptions& options);

/// Marks the rows of an axis that allows no difference whose image is not that of the first value
/// (of its scene and method): a fault, and no result.
void note_differences(const Axis& axis, std::vector<AxisRow>& rows);

}  // namespace ink::studies
