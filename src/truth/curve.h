#pragma once

#include <cstdint>

#include "core/image.h"
#include "truth/line_class.h"

namespace ink::truth {

/// A point of a visible line: where it is on the image and how far away.
struct CurvePoint {
    double x_px = 0;
    double y_px = 0;
    double w = 0;  ///< distance along the view direction, world units
};

/// What lies behind a contour.
enum class ContourKind : std::uint8_t { none, sky, other_object, self };

inline constexpr std::uint32_t kNoEdge = 0xffffffffU;
inline constexpr std::uint32_t kNoTriangle = 0xffffffffU;

/// A visible piece of one line, clipped to the image: of a mesh edge, or of an intersection.
///
/// What is said of its faces and its surroundings holds at the middle of the piece.
struct Curve {
    LineClass line_class = LineClass::none;
    ContourKind kind = ContourKind::none;  ///< contours only
    std::int8_t empty_side =
        0;  ///< contours and boundaries: the side without a face of the line's,
            ///< going from begin to end on the image: 1 right, -1 left; else 0
    std::uint32_t edge = kNoEdge;       ///< into the scene's Topology; kNoEdge for an intersection
    std::uint32_t face0 = kNoTriangle;  ///< a face on the line, into Topology::faces: the seen one
                                        ///< of contour and boundary, else the left one
    std::uint32_t face1 = kNoTriangle;  ///< the other (of a contour hidden, or in the line of
                                        ///< sight); kNoTriangle for a boundary
    float deviation_rad =
        0;          ///< how far the two seen faces deviate from flat (dihedral); 0 for one
    float gap = 0;  ///< from the line to what lies behind it, along the view direction, world
                    ///< units; infinity before the sky, 0 for lines that have both sides
    float view_angle_rad = 0;  ///< between the line of sight and the normal of that seen face which
                               ///< is nearest edge-on: 0 seen from the front .. pi/2 edge-on
    CurvePoint begin;
    CurvePoint end;
};

/// Whether a curve is an intersection whose two seen faces bend by less than the crease angle. A
/// bend that is the angle but for the rounding of a float is not less.
[[nodiscard]] constexpr bool is_below_crease(const Curve& curve, double crease_rad) {
    return curve.line_class == LineClass::intersection &&
           curve.deviation_rad < static_cast<float>(crease_rad);
}

/// Between which neighbouring pixel centres the visible lines run: the second, thinning-free
/// product.
///
/// `right.at(x, y)` is the LineClass (the lowest number of several, 0 for none) of the curves that
/// cross the open segment from the centre of (x, y) to that of (x + 1, y), `below` the same to
/// (x, y + 1). The last column of `right` and the last row of `below` are 0.
struct Cracks {
    core::Image<std::uint8_t> right;
    core::Image<std::uint8_t> below;
};

}  // namespace ink::truth
