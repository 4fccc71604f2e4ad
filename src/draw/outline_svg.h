#pragma once

#include <string>

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

}  // namespace ink::draw
