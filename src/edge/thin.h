#pragma once

#include "edge/bit_mask.h"
#include "edge/edge_image.h"

namespace ink::edge {

/// The least edge response that counts as on at k/100 of the full one (k in 1..99): edge response *
/// 100 >= 255 * k in integers, so that no rounding decides a tie.
[[nodiscard]] constexpr int response_at_percent(int k) {
    return (255 * k + 99) / 100;
}

/// Guo-Hall thinning to convergence: lines become one pixel wide, 8-connected pieces stay so, 2x2
/// squares stay (MATLAB's `bwmorph(m, 'thin', Inf)`, scikit-image's `thin`; not OpenCV's operator
/// of the same name, which never touches the image's border).
///
/// `mask` holds 0 or 1; outside it everything is 0, so lines along the frame are thinned like any
/// other. Returns a subset of the same size; thinning it again changes nothing. Not invariant under
/// transposition. Costs one pass over the image plus work in proportion to the set pixels.
///
/// Source: Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989,
/// conditions G1, G2 and G3 (G3' in the second subiteration).
[[nodiscard]] Mask thin(const Mask& mask);

/// The same in place.
void thin(BitMask& mask);

}  // namespace ink::edge
