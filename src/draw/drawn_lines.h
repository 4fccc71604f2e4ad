#pragma once

#include <vector>

#include "truth/join_curves.h"
#include "truth/model.h"
#include "truth/trace_lines.h"

namespace ink::draw {

/// The lines of a view as long runs of one class: what a drawing shows.
struct DrawnLines {
    std::vector<truth::Polyline> visible;
    std::vector<truth::Polyline> hidden;  ///< empty unless asked for
};

/// Traces the lines of a view alone. The same for every thread count; throws as
/// truth::trace_lines(). An empty image has no lines.
[[nodiscard]] truth::TracedLines trace_drawn_lines(const truth::Model& model,
                                                   const scene::View& view,
                                                   const truth::TruthTrace& trace,
                                                   truth::Hidden hidden);

/// Joins pieces by class, whatever lies behind them: a run ends at a corner where more than two
/// pieces of its class meet, or where it becomes hidden. Nothing is known of kind and empty side.
[[nodiscard]] DrawnLines joined_by_class(truth::TracedLines lines);

}  // namespace ink::draw
