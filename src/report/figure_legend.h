#pragma once

#include <vector>

#include "report/figure_views.h"
#include "report/picture_grid.h"

namespace ink::report {

/// What the colours of these pictures mean, those alone that are there: a group of right and
/// missing, one of false and uncounted pixels, one of the truth's classes.
[[nodiscard]] std::vector<std::vector<LegendEntry>> legend_of(
    const std::vector<FigureView>& views, const std::vector<const FigureEvaluation*>& evaluations);

}  // namespace ink::report
