#pragma once

#include <vector>

#include "edge/edge_image.h"
#include "harness/miss_prediction.h"
#include "harness/truth_code.h"

namespace ink::linear_code {

/// The pixels round which a four-neighbour stencil sees a true line (score::sees_line) and that
/// have four neighbours, row by row: the same for every code.
[[nodiscard]] std::vector<score::Pixel> line_stencils(const score::TruthStencils& stencils);

/// Which pixels a declared code draws along the true lines of a view: 1 where the four-neighbour
/// stencil round a pixel sees a line (score::sees_line) and the filter's response to it reaches the
/// threshold; not thinned, of the view's size.
///
/// From the truth's geometry and the declared code alone, never from a method's image. What each
/// pixel centre sees is the truth's. So a crease has what it has on a real image: one to three
/// neighbours on its other side, the kink that 1/w has there instead of a jump, and codes that are
/// rounded. Stencils that the frame cuts, and those that no line crosses, draw nothing.
///
/// `triangle` is the truth's layer, `seeing` its line_stencils(); `declared` has a code: the one
/// that `code` was made of.
[[nodiscard]] edge::Mask predicted_positives(const harness::TruthCode& code,
                                             const core::Image<std::uint32_t>& triangle,
                                             const std::vector<score::Pixel>& seeing,
                                             const harness::Declaration& declared);

}  // namespace ink::linear_code
