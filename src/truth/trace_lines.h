#pragma once

#include <cstddef>
#include <vector>

#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/truth.h"

namespace ink::truth {

/// The visible lines of a view and what finding them cost.
struct TracedLines {
    std::vector<Curve> curves;  ///< sorted by edge, then along it from a to b; then the crossings
    std::vector<Curve>
        hidden;  ///< what of the same lines is hidden, so sorted, if it was asked for
    std::size_t candidate_edges = 0;  ///< edges with a line inside the image
    std::size_t samples = 0;
    std::size_t rays = 0;
};

enum class Hidden { leave_out, keep };

/// Construction A: clips every feature edge and every crossing of two faces to near plane and
/// image, samples it at most 1/4 px apart and bisects each change of visibility (of a contour
/// also each change of what lies behind it) to 1/512 px. The same for every thread count. Throws
/// TooLarge once samples or rays exceed `trace.limits`, or where too many crossings were to be
/// found.
///
/// Hidden pieces have no kind. With the visible ones they are all of every line that is clipped.
[[nodiscard]] TracedLines trace_lines(const EyeView& eye,
                                      const EyeScene& scene,
                                      const TruthOptions& options,
                                      Hidden hidden = Hidden::leave_out);

}  // namespace ink::truth
