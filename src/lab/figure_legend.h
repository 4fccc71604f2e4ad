#pragma once

#include <vector>

#include "lab/figure_views.h"
#include "lab/picture_grid.h"

namespace ink::lab {

/// What the colours of these pictures mean, those alone that are there: a group of right and
/// missing, one of false and uncounted pixels, one of the truth's classes.
[[nodiscard]] std::vector<std::vector<LegendEntry>> legend_of(
    const std::vector<FigureView>& views, const std::vector<const FigureShot*>& shots);

}  // namespace ink::lab
