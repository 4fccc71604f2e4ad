#pragma once

#include <cstdint>
#include <vector>

#include "harness/cells/view_cells.h"
#include "harness/rows/side_tables.h"
#include "method/method.h"
#include "scene/scene.h"
#include "studies/axis.h"
#include "truth/truth.h"

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

/// The columns of stress.csv: cell, non_finite, overflow, lost_cell, differing.
[[nodiscard]] const harness::SideTable<AxisRow>& faults_table();

/// The lines of stress.csv with the rows of their cells. Throws core::Error (file, line, column,
/// value) for another heading, a wrong field or an unknown cell.
[[nodiscard]] std::vector<AxisRow> read_faults(const core::CsvTable& csv,
                                               const harness::RowIndex& rows);

/// axes.csv: what each axis of a run varies, for who reads its values.
[[nodiscard]] const core::TableOf<Axis>& axes_table();

/// What a method is given in one case: numbers that are not finite, and depths outside 0..1,
/// counted over vertices and over the pixels of full buffers in every encoding.
///
/// Normals may be a little longer than 1: where a triangle is thinner than the grid by which pixels
/// are covered, its planes are read beyond its sides.
[[nodiscard]] CaseFaults count_inputs(const scene::Scene& scene, const scene::View& view);

/// Numbers of a truth that are not finite (what lies behind a line may be infinitely far).
[[nodiscard]] std::int64_t count_non_finite(const truth::Truth& truth);

/// Numbers of a row's scores that are not finite or outside 0..1.
[[nodiscard]] std::int64_t count_non_finite(const harness::Row& row);

/// Pixels at which the packed code of `method`, made by `config` and ready for `scene`, overflows:
/// where it comes out otherwise if overflow wraps instead of saturating, or the other way round.
///
/// 0 for methods without packed codes, and for codes whose ranges exceed their bits: those overflow
/// by intent.
[[nodiscard]] std::int64_t count_overflow(method::Method& method,
                                          const method::MethodConfig& config,
                                          const scene::Scene& scene,
                                          const method::Frame& frame);

}  // namespace ink::studies
