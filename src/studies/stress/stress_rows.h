#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/cell.h"
#include "harness/row.h"
#include "harness/tracing.h"
#include "studies/stress/stress_axes.h"

namespace ink::studies {

/// What must not happen, however hard a case is.
struct StressCounts {
    /// Numbers that are NaN or infinite: placed and projected vertices, normals, the planes of a
    /// full buffer in every depth encoding, the truth's curves, the declared code, the scores.
    std::int64_t non_finite = 0;
    /// Codes beyond what they may hold: depths outside 0..1, and pixels at which a packed
    /// code whose ranges fit its bits comes out otherwise if it may wrap.
    std::int64_t overflow = 0;
    std::int64_t lost = 0;       ///< 1 if the cell has no result
    std::int64_t differing = 0;  ///< 1 if the image differs where the axis allows none to

    [[nodiscard]] bool is_clean() const {
        return non_finite == 0 && overflow == 0 && lost == 0 && differing == 0;
    }
    void add(const StressCounts& more);
};

/// A row of stress.csv: a cell, its place on an axis, and what went wrong in it.
struct StressRow {
    std::string axis;
    double value = 0;
    std::string unit;
    harness::Row row;
    StressCounts counts = {};
};

/// Draws and scores one case: the baselines `none`, `sampled`, `exact_corner`, `oracle` first,
/// then a row per configuration.
///
/// Nothing is timed and rows hold no times, so they are the same bytes on every machine. A method
/// that throws is a row whose status says so. Only `threads` and `skips` of `measure` are read; of
/// `trace`, cross-check is not.
[[nodiscard]] std::vector<StressRow> stress_rows(const StressCase& stress,
                                                 const std::vector<harness::MethodConfig>& configs,
                                                 const harness::MeasureOptions& measure,
                                                 const harness::TraceOptions& trace);

/// Marks the rows of axes that allow no difference whose image is not that of the axis' first
/// value (of its scene and method). Other rows stay.
void note_differences(std::vector<StressRow>& rows);

}  // namespace ink::studies
