#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "score/score.h"

namespace ink::statistics {

/// The curve of one cell, with what is needed to pool it.
struct CellCurve {
    std::string method;
    std::array<score::CurveCount, 99> counts{};
};

/// Optimal data-set scale (BSDS): the edge response 1..255, at and above which a pixel is on, with
/// the highest F of counts that are pooled over a set. Of neighbours with that F the middle one: a
/// method that draws 0 and 255 alone gets 128.
///
/// A method's shipped `threshold` is found by this, once; a cell's score never depends on it.
[[nodiscard]] int best_threshold(const std::array<score::CurveCount, 99>& counts);

/// Per method the area under the envelope of the pooled precision-recall curve, from recall 0.
///
/// Source: Arbelaez, Maire, Fowlkes and Malik, "Contour detection and hierarchical image
/// segmentation", PAMI 33(5), 2011, section 3.1, for ODS and AP.
[[nodiscard]] std::map<std::string, double> pooled_ap(const std::vector<CellCurve>& curves);

}  // namespace ink::statistics
