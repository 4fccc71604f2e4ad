#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "harness/suite/suite.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace ink::studies {

// What a sensible view is. The eye stays outside the ball, and so outside every solid.
inline constexpr double kNearest_radii = 1.05;  ///< from the ball's centre to the eye
inline constexpr double kFarthest_radii = 6;
inline constexpr double kLeastFov_deg = 20;
inline constexpr double kMostFov_deg = 90;
/// Fields of view across the angle that the ball takes, at most: what is far is small, and small
/// things are hard for every method.
inline constexpr double kMostFovOfBall = 3;
inline constexpr int kMoments = 32;  ///< steps of an animation's duration

/// A camera and a moment as --eye, --target, --fov and --time have them; up is 0,1,0.
struct ViewChoice {
    glm::dvec3 eye{0};  ///< in the file's own coordinates (Scene::origin), as target is
    glm::dvec3 target{0};
    double fov_deg = 40;
    std::optional<double> time_s = {};  ///< of an animated scene

    [[nodiscard]] harness::CameraRequest camera() const;
};

/// The sensible views of a scene as points of the unit cube: two coordinates for the direction to
/// the eye, one for its distance, three for the target within the scene's box, one for the field of
/// view, and one for the moment of an animated scene.
///
/// Box and ball hold every moment that is looked at. Numbers come rounded, so that a choice can be
/// typed: lengths to about a ten thousandth of the radius, angles to 0.1 degrees, moments to a
/// millisecond.
class ViewSpace {
  public:
    /// Throws core::Error (where = the scene's name) if all points are at one place.
    explicit ViewSpace(const scene::Scene& scene);

    [[nodiscard]] std::size_t size() const { return duration_s_ ? 8 : 7; }
    /// The choice at `point`, whose coordinates are 0..1.
    [[nodiscard]] ViewChoice at(const std::vector<double>& point) const;
    /// The point whose choice is nearest to what `camera` sees, at the first moment.
    [[nodiscard]] std::vector<double> point_of(const scene::Camera& camera) const;
    /// The unit direction from the ball's centre to the eye.
    [[nodiscard]] glm::dvec3 direction(const ViewChoice& choice) const;
    /// A ball round the box.
    [[nodiscard]] const scene::Sphere& ball() const { return ball_; }

  private:
    [[nodiscard]] glm::dvec3 rounded(const glm::dvec3& p_world) const;

    glm::dvec3 origin_;
    glm::dvec3 low_world_{0};
    glm::dvec3 high_world_{0};
    scene::Sphere ball_;
    std::optional<double> duration_s_;
};

}  // namespace ink::studies
