#pragma once

#include <glm/vec3.hpp>

#include "scene/viewpoint.h"

namespace ink::scene {

/// The sign (-1, 0, 1) of the determinant |a-d, b-d, c-d|, exact for every finite input whose
/// products neither overflow nor underflow.
///
/// Positive when d lies behind the plane, that is, where a, b, c run clockwise; negative in front
/// of it; 0 in it. A static error bound decides nearly all calls in double; the rest are summed
/// exactly as floating-point expansions (Shewchuk 1997, "Adaptive precision floating-point
/// arithmetic", sections 2 and 4).
[[nodiscard]] int orient3d(const glm::dvec3& a,
                           const glm::dvec3& b,
                           const glm::dvec3& c,
                           const glm::dvec3& d);

/// The same with the eye in place of d: exact for a direction, too, where it is the sign of
/// |a - eye, b - eye, c - eye| for an eye that moves away against it without end.
[[nodiscard]] int orient3d(const glm::dvec3& a,
                           const glm::dvec3& b,
                           const glm::dvec3& c,
                           const Viewpoint& eye);

/// The determinant itself, its sign exact and its relative error below 1e-13: for points where two
/// planes cross, which are quotients of such volumes.
[[nodiscard]] double orient3d_value(const glm::dvec3& a,
                                    const glm::dvec3& b,
                                    const glm::dvec3& c,
                                    const glm::dvec3& d);

/// Whether a, b, c lie exactly on one line (coincident points do).
[[nodiscard]] bool is_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The side of the plane of face (a, b, c) on which a point lies: 1 before its front
/// (counter-clockwise), -1 behind its back, 0 in it.
[[nodiscard]] inline int facing(const glm::dvec3& a,
                                const glm::dvec3& b,
                                const glm::dvec3& c,
                                const glm::dvec3& point) {
    return -orient3d(a, b, c, point);
}

/// The same of an eye: 1 it sees the front, -1 the back, 0 the face is exactly edge-on. Facing by
/// where the eye is; by the direction of sight only where that is the same for all points.
[[nodiscard]] inline int facing(const glm::dvec3& a,
                                const glm::dvec3& b,
                                const glm::dvec3& c,
                                const Viewpoint& eye) {
    return -orient3d(a, b, c, eye);
}

}  // namespace ink::scene
