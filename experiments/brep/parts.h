#pragma once

#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <cstdint>
#include <gp_Pnt.hxx>
#include <set>
#include <utility>
#include <vector>

namespace brep {

/// The ends of a mesh edge, the lower number first.
using Segment = std::pair<std::uint32_t, std::uint32_t>;

[[nodiscard]] inline Segment segment(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// What the edges of a model are, each counted once however often it is placed.
struct EdgeCounts {
    int all = 0;         ///< that have a length
    int degenerate = 0;  ///< points: the pole of a sphere
    int seams = 0;       ///< of one face with itself, and smooth
    int free = 0;        ///< of one face, once
    int tangent = 0;     ///< of two faces, nowhere sharp
    int sharp = 0;       ///< of two faces or more, somewhere sharp
    int partly = 0;      ///< of these, those that are tangent somewhere
    int unmeshed = 0;    ///< without points that their faces share
};

/// An object of the file to be written.
struct Part {
    std::vector<gp_Pnt> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::set<Segment> hard;
};

/// The triangles of a tessellated shape: a part per solid, and one of the faces that are in none.
/// Faces that meet by at most `tangent_rad` are smooth there. Adds to the counts. Throws
/// std::runtime_error for a face without triangles.
[[nodiscard]] std::vector<Part> make_parts(const TopoDS_Shape& shape,
                                           double tangent_rad,
                                           EdgeCounts& counts);

}  // namespace brep
