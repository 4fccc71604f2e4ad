#pragma once

#include <string>
#include <vector>

#include "harness/row.h"
#include "statistics/ods.h"

namespace ink::experiment {

/// The columns of summary.csv, in order: method, kind (method or bracket), views and scenes it was
/// scored on, failed cells; F pooled at 2 px with its 95 % interval (f_lo, f_hi), over training and
/// held-out scenes, as the mean of scenes, at 1 px; precision, recall, average precision; draw_ms,
/// the median over views, with its quartiles (draw_ms_lo, draw_ms_hi); bytes_per_px; and for each
/// line class recall_<class> with its 95 % interval (_lo, _hi).
[[nodiscard]] const std::vector<std::string>& summary_columns();

/// A table (RFC 4180, "\n" line ends) with a line per method of `rows`, in order of first
/// appearance, the brackets last; what there is none of is empty. `curves` give average precision;
/// no rows give the heading alone. Numbers are in the shortest form that reads back to the same
/// value.
[[nodiscard]] std::string summary_csv(const std::vector<harness::Row>& rows,
                                      const std::vector<statistics::CellCurve>& curves);

}  // namespace ink::experiment
