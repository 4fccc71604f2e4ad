#pragma once

#include <glm/mat4x4.hpp>

namespace ink::import {

/// How an FBX file says its coordinates are meant (GlobalSettings).
struct FbxAxes {
    struct Axis {
        int number = 0;  ///< 0, 1, 2: x, y, z
        int sign = 1;
    };
    Axis up{1, 1};
    Axis front{2, 1};  ///< towards who looks at it
    Axis right{0, 1};  ///< called Coord there
    double cm_per_unit = 1;
};

/// Turns the file's coordinates so that y is up: z up becomes (x, z, -y), x up (-y, x, z).
/// Left-handed axes are mirrored along the front. Lengths become centimetres.
[[nodiscard]] glm::dmat4 y_up_from_fbx(const FbxAxes& axes);

}  // namespace ink::import
