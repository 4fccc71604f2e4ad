#pragma once

#include <array>

#include "crosscheck/mesh_walk.h"

namespace ink::crosscheck {

/// A line between two samples.
struct NamedLine {
    truth::LineClass line_class = truth::LineClass::none;
    double slant = 1;               ///< |cos| + |sin| of the line's direction on the image
    std::uint32_t edge = kNothing;  ///< of the mesh; nothing where two surfaces cross
};

/// What lies between two samples: up to two lines of surfaces that end at one place, or an
/// intersection and a feature of either surface just before it.
struct Between {
    std::array<NamedLine, 3> lines;
    int count = 0;
    bool is_defect = false;    ///< a border was met across which the surface goes on
    bool is_near_cut = false;  ///< what is seen ends at the near plane
    bool is_explained = true;  ///< false: the samples differ, and nothing says why
};

/// Names what separates two samples that are not joined and lie very close: the nearer surface that
/// ends there (contour, boundary), a bend or another object on the surface that goes on (crease,
/// seam), or two surfaces that go on through each other (intersection; and what bends on either
/// before that). Two in one plane are one surface: only what bends on it, or a seam, is a line. A
/// border's end is a defect if the surface goes on right behind it, for which one more sample is
/// taken.
[[nodiscard]] Between name_between(const SightRays& rays, const Sample& from, const Sample& to);

}  // namespace ink::crosscheck
