#pragma once

#include <array>
#include <string>
#include <vector>

#include "score/score.h"

namespace ink::statistics {

/// The curve of one cell, with what is needed to pool it.
struct CellCurve {
    std::string method;
    bool is_training = false;
    std::array<score::CurveCount, 99> counts{};
};

/// The one threshold that is best for a whole set of images.
struct OdsPoint {
    std::string method;
    int threshold = 0;  ///< edge response 1..255 at and above which a pixel is on
    double f = 0;       ///< F of the counts pooled over the set, at that threshold
};

/// Optimal data-set scale: per method, in order of first appearance, the threshold with the highest
/// F of the counts pooled over the training cells (BSDS). Of neighbours with that F the middle one:
/// a method that draws 0 and 255 alone gets 128.
///
/// A method's shipped `threshold` is found by this, once; a cell's score never depends on it.
/// Methods without a training cell are left out.
[[nodiscard]] std::vector<OdsPoint> ods_on_training(const std::vector<CellCurve>& curves);

/// What the curves of one method say together, over all the cells that were given.
///
/// Source: Arbelaez, Maire, Fowlkes and Malik, "Contour detection and hierarchical image
/// segmentation", PAMI 33(5), 2011, section 3.1, for ODS, OIS and AP.
struct CurveSummary {
    OdsPoint ods;
    /// Optimal image scale: F of the counts pooled over cells, each at the threshold where its own
    /// F is highest (the lowest on a tie). As a rule at least ODS, and what a perfect choice of
    /// threshold per image would gain; it can fall below by a little, because the highest F of
    /// one image need not add most to the pool.
    double ois = 0;
    /// Area under the envelope of the pooled precision-recall curve, from recall 0.
    double ap = 0;
};

/// One summary per method, in order of first appearance.
[[nodiscard]] std::vector<CurveSummary> summarise_curves(const std::vector<CellCurve>& curves);

}  // namespace ink::statistics
