#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::scene {

/// How large a part of an image a scene takes.
struct Frame {
    double fov_y_rad = 0;
    double width_over_height = 1;
    double fill = 1;  ///< share of the image's width or height, whichever the scene reaches
};

/// The vertices of all instances that a triangle uses, in world space.
[[nodiscard]] std::vector<glm::dvec3> placed_points(const Scene& scene);

/// The eye that looks along -z of `view_from_world` and is as near as the frame allows, exactly:
/// each side of the filled part is a plane through the eye, and on two opposite sides some point
/// touches it. `points` has one point at least.
[[nodiscard]] glm::dvec3 fitted_eye(std::span<const glm::dvec3> points,
                                    const glm::dmat3& view_from_world,
                                    const Frame& frame);

/// `camera` moved without turning, so that `points` fill its frame, of its own angle of view; a
/// parallel one stands before the ball of all of `scene` and has the height that they take. Its
/// near and far planes hold all of `scene` that is before it. Points all at one place leave it as
/// it is.
[[nodiscard]] Camera framed(Camera camera,
                            std::span<const glm::dvec3> points,
                            double width_over_height,
                            double fill,
                            const Scene& scene);

/// The instances called one of `names` alone, at rest. Throws Error (where = the scene's name) that
/// lists the names there are for one that is not.
[[nodiscard]] Scene only_objects(const Scene& scene, std::span<const std::string> names);

}  // namespace ink::scene
