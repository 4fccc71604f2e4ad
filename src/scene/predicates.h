#pragma once

#include <glm/vec3.hpp>

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

/// The determinant itself, its sign exact and its relative error below 1e-13: for points where two
/// planes cross, which are quotients of such volumes.
[[nodiscard]] double orient3d_value(const glm::dvec3& a,
                                    const glm::dvec3& b,
                                    const glm::dvec3& c,
                                    const glm::dvec3& d);

/// Whether a, b, c lie exactly on one line (coincident points do).
[[nodiscard]] bool is_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The side of the plane of face (a, b, c) on which the eye lies: 1 it sees the front
/// (counter-clockwise), -1 the back, 0 the face is exactly edge-on. Facing by the eye's position,
/// never by the view direction.
[[nodiscard]] inline int facing(const glm::dvec3& a,
                                const glm::dvec3& b,
                                const glm::dvec3& c,
                                const glm::dvec3& eye) {
    return -orient3d(a, b, c, eye);
}

}  // namespace ink::scene
