#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "truth/truth.h"

namespace ink::draw {

/// The curves of a truth as an SVG file in the image's own coordinates, px.
///
/// A group per class and kind (`data-class`, `data-kind`: sky, other_object, self) holds polylines
/// of curves joined end to end. Each says of its segments, in order: the mesh edges (`data-edge`,
/// "-" for none), how far the faces bend (`data-dihedral-deg`), and for contours and boundaries the
/// depth gap (`data-gap`, "inf" before the sky); `data-empty` is the hand on which nothing is (left
/// or right, going along). `view` is the traced one. Points are rounded to 1/1000 px.
[[nodiscard]] std::string outline_svg(const truth::Truth& truth,
                                      const std::string& scene_name,
                                      const scene::View& view);

/// The visible lines of a class as the path of an SVG in the image's own coordinates, px.
struct ClassPath {
    std::string_view line_class;
    std::string path;  ///< as "M1,2 3,4M5,6 7,8", rounded to 1/100 px
};

/// The classes that a truth has lines of, in the order of drawing.
[[nodiscard]] std::vector<ClassPath> class_paths(const truth::Truth& truth);

}  // namespace ink::draw
