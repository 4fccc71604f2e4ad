#pragma once

#include <cstdint>

#include "truth/eye_view.h"
#include "truth/truth.h"

namespace ink::truth {

/// The rule of touching faces, for a point of a mesh edge that lies in faces of others
/// (Crossings::contacts): inside them, or on their border.
///
/// There the edge's own faces and those it touches are one bundle of sheets round the edge. On
/// either side of it only the sheet nearest the eye is seen; of coplanar ones the lowest face, as
/// everywhere. The edge is a line where
/// - its own faces are seen on both sides, or on one with nothing on the other: as without the
///   touching faces;
/// - an own face is seen on one side and a touching one on the other. If the touching face holds
/// the
///   edge inside and own faces go on behind it, they pierce it there: an intersection at any angle,
///   as between any two faces, unless it lies in the plane of an own one. Else, if the two bend by
///   less than a crease, the surface goes on: a seam between two objects, and within one nothing.
///   Else the edge keeps the class that its own faces give it if that is a contour or a boundary (a
///   box on a floor; what goes on beyond a border is hidden there and does not count), or a
///   crease whose other face coincides with the touching one; what is left is an intersection, if
///   the edge of the touching face that lies there is not drawn by this rule.
/// Where no own face is seen the edge is hidden, though no face stands before it: the foot of a
/// wall seen through the floor it stands on, or the outline of a tile under a coincident one.
///
/// Two edges of two faces each that lie on each other, and would both be the same intersection, are
/// one line: that of the edge whose seen face is the lower.

/// What is seen to one side of a point of an edge, of own and touching faces.
struct SeenSheet {
    std::uint32_t face = kNoFace;    ///< kNoFace: nothing
    std::uint32_t border = kNoEdge;  ///< the face's edge that lies there, if the face ends there
};

/// The same for both sides: what EyeView::seen_faces is for the own faces alone.
struct SeenSheets {
    SeenSheet left, right;
};

/// What is seen to either side of the point a + t (b - a).
[[nodiscard]] SeenSheets seen_sheets_at(const EyeView& eye, std::uint32_t edge, double t);

/// How far the two seen sheets deviate from flat there, 0..pi; 0 where one side is empty.
[[nodiscard]] double seen_deviation_rad(const EyeView& eye, std::uint32_t edge, double t);

/// The class of that point by the rule above, if `own_class` is what it is without the touching
/// faces.
[[nodiscard]] LineClass touched_class(const EyeView& eye,
                                      std::uint32_t edge,
                                      double t,
                                      LineClass own_class);

}  // namespace ink::truth
