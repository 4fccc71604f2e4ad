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

/// How many rows a case comes to.
[[nodiscard]] int rows_of_case(const Axis& axis, std::size_t configs);

/// Draws one case of an axis with every configuration, and scores and times it as the axis has it:
/// a row per configuration, then the baselines where it is scored.
///
/// A method that throws is a row whose status says so. Where nothing is timed, rows hold no times:
/// they are the same bytes on every machine. Of `options`, repetitions and budget are not read.
[[nodiscard]] std::vector<AxisRow> axis_rows(const Axis& axis,
                                             const Case& one,
                                             const std::vector<method::MethodConfig>& configs,
                                             const harness::CellOptions& options);

/// Marks the rows of an axis that allows no difference whose image is not that of the first value
/// (of its scene and method): a fault, and no result.
void note_differences(const Axis& axis, std::vector<AxisRow>& rows);

}  // namespace ink::studies
