#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ink::scene {

/// Where a view looks from: a point, or, of a parallel camera, a place infinitely far away, from
/// which all lines of sight run along one direction.
struct Viewpoint {
    glm::dvec3 at_world{0};  ///< the point, or the direction of sight, 1 long
    bool is_direction = false;
    /// The direction as it was given, of any length: at_world is it but for rounding. 0: at_world.
    glm::dvec3 given_world{0};

    /// What decides on which side of a plane it is.
    [[nodiscard]] const glm::dvec3& exact() const {
        return given_world == glm::dvec3(0) ? at_world : given_world;
    }
    /// From the eye towards a point; of any length.
    [[nodiscard]] glm::dvec3 sight(const glm::dvec3& p_world) const {
        return is_direction ? at_world : p_world - at_world;
    }
    /// A normal of the plane through the eye and two points, (a - eye) x (b - eye) in perspective.
    [[nodiscard]] glm::dvec3 plane(const glm::dvec3& a_world, const glm::dvec3& b_world) const {
        return is_direction ? glm::cross(at_world, b_world - a_world)
                            : glm::cross(a_world - at_world, b_world - at_world);
    }
    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// A line of sight from where it has depth 0, the eye in perspective.
struct SightLine {
    glm::dvec3 begin_world{0};
    glm::dvec3 way_world{0};
};

}  // namespace ink::scene
