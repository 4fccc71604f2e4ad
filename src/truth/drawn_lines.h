#pragma once

#include <vector>

#include "truth/join_curves.h"
#include "truth/model.h"
#include "truth/trace_lines.h"

namespace ink::truth {

/// The lines of a view as long runs of one class: what a drawing shows.
struct DrawnLines {
    std::vector<Polyline> visible;
    std::vector<Polyline> hidden;  ///< empty unless asked for
};

/// Traces the lines of a view alone and joins their pieces by class, whatever lies behind them: a
/// run ends at a corner where more than two pieces of its class meet, or where it becomes hidden.
/// Nothing is known of kind and empty side. The same for every thread count; throws as
/// trace_lines(). An empty image has no lines.
[[nodiscard]] DrawnLines trace_drawn_lines(const Model& model,
                                           const scene::View& view,
                                           const TruthTrace& trace,
                                           Hidden hidden);

}  // namespace ink::truth
