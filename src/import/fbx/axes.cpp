#include "import/fbx/axes.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace ink::import {
namespace {

/// The axis in the file's coordinates; nothing of none.
glm::dvec3 direction(const FbxAxes::Axis& axis) {
    glm::dvec3 result{0};
    if (axis.number >= 0 && axis.number < 3) result[axis.number] = axis.sign < 0 ? -1 : 1;
    return result;
}

/// Columns are where the file's x, y and z go.
glm::dmat3 turned_up(const FbxAxes::Axis& up) {
    const double sign = up.sign < 0 ? -1 : 1;
    switch (up.number) {
        case 0:
            return {{0, sign, 0}, {-sign, 0, 0}, {0, 0, 1}};
        case 2:
            return {{1, 0, 0}, {0, 0, -sign}, {0, sign, 0}};
        default:
            return {{1, 0, 0}, {0, sign, 0}, {0, 0, sign}};
    }
}

}  // namespace

glm::dmat4 y_up_from_fbx(const FbxAxes& axes) {
    glm::dmat3 turn = turned_up(axes.up);
    const glm::dmat3 frame(direction(axes.right), direction(axes.up), direction(axes.front));
    if (glm::determinant(frame) < 0) turn[axes.front.number] = -turn[axes.front.number];
    const bool has_unit = std::isfinite(axes.cm_per_unit) && axes.cm_per_unit > 0;
    return glm::dmat4(turn * (has_unit ? axes.cm_per_unit : 1.0));
}

}  // namespace ink::import
