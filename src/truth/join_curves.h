#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "truth/truth.h"

namespace ink::truth {

/// A run of curves joined end to end, all of one class and kind.
struct Polyline {
    LineClass line_class = LineClass::none;
    ContourKind kind = ContourKind::none;
    std::int8_t empty_side = 0;         ///< as in Curve, going along the polyline
    std::vector<CurvePoint> points;     ///< one more than curves; the first again where it closes
    std::vector<std::uint32_t> curves;  ///< into the curves that were joined, in order
};

/// Joins curves where two, and no more, of one class and kind end at one vertex with their empty
/// side on the same hand. So a corner where three creases meet ends all three, and a contour breaks
/// where what lies behind it changes. Each curve is in exactly one polyline.
///
/// Polylines come in the order of their lowest curve, which runs forward in it where the polyline
/// is closed or starts there. O(n log n). No curves give no polylines.
[[nodiscard]] std::vector<Polyline> join_curves(std::span<const Curve> curves);

}  // namespace ink::truth
