#pragma once

#include <array>
#include <string>
#include <vector>

#include "score/score.h"

namespace ink::lab {

/// The curve of one cell, with what is needed to pool it.
struct CellCurve {
    std::string method;
    bool is_training = false;
    std::array<score::CurveCount, 99> counts{};
};

/// The one threshold that is best for a whole set of pictures.
struct OdsPoint {
    std::string method;
    int threshold = 0;  ///< strength 1..255 at and above which a pixel is on
    double f = 0;       ///< F of the counts pooled over the set, at that threshold
};

/// Optimal data-set scale: per method, in order of first appearance, the threshold with the highest
/// F of the counts pooled over the training cells (BSDS; the lowest threshold on a tie).
///
/// A method's shipped `threshold` is found by this, once; a cell's score never depends on it.
/// Methods without a training cell are left out.
[[nodiscard]] std::vector<OdsPoint> ods_on_training(const std::vector<CellCurve>& curves);

}  // namespace ink::lab
