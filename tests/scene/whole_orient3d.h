#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace ink::scene {

/// The sign of the determinant of a, b and c seen from d, in doubles as they round.
inline int plain_double_orient3d(const glm::dvec3& a,
                                 const glm::dvec3& b,
                                 const glm::dvec3& c,
                                 const glm::dvec3& d) {
    const glm::dvec3 u = a - d, v = b - d, w = c - d;
    const double det = u.z * (v.x * w.y - w.x * v.y) + v.z * (w.x * u.y - u.x * w.y) +
                       w.z * (u.x * v.y - v.x * u.y);
    return (det > 0) - (det < 0);
}

/// The same of points whose coordinates are whole numbers below 2^30, in 128-bit integers.
inline int integer_orient3d(const glm::dvec3& a,
                            const glm::dvec3& b,
                            const glm::dvec3& c,
                            const glm::dvec3& d) {
    __extension__ typedef __int128 Wide;
    const auto minus = [](double x, double y) { return Wide(std::llround(x) - std::llround(y)); };
    const Wide ux = minus(a.x, d.x), uy = minus(a.y, d.y), uz = minus(a.z, d.z);
    const Wide vx = minus(b.x, d.x), vy = minus(b.y, d.y), vz = minus(b.z, d.z);
    const Wide wx = minus(c.x, d.x), wy = minus(c.y, d.y), wz = minus(c.z, d.z);
    const Wide det = uz * (vx * wy - wx * vy) + vz * (wx * uy - ux * wy) + wz * (ux * vy - vx * uy);
    return (det > 0) - (det < 0);
}

}  // namespace ink::scene
