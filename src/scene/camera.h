#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace ink::scene {

/// A ball that holds a scene, world space. `radius` 0 for an empty scene.
struct Sphere {
    glm::dvec3 center_world{0};
    double radius = 0;
};

/// A pinhole camera: right-handed, y up, looks along -z of its own view space (glTF's convention).
struct Camera {
    std::string name;
    glm::dvec3 eye_world{0, 0, 1};
    /// Rotates eye-relative world vectors into view space: rows are right, up and back.
    glm::dmat3 view_from_world{1};
    double fov_y_rad = 0.6981317007977318;  ///< 40 degrees, vertical
    double near = 0.01;                     ///< distance of the near plane along -z, > 0
    double far = 100;  ///< only scales depth encodings and z buffers; nothing is clipped there
};

/// A camera and the size of its image.
struct View {
    Camera camera;
    int width_px = 0;
    int height_px = 0;
};

/// A camera at `eye_world` that looks at `target_world`, near and far not yet fitted.
///
/// `up_world` need not be orthogonal to the view direction. If the two are parallel (or `up` is
/// zero), another axis is taken, so the result is always a rotation. Throws Error if eye and target
/// coincide or any number is not finite.
[[nodiscard]] Camera look_at(const glm::dvec3& eye_world,
                             const glm::dvec3& target_world,
                             const glm::dvec3& up_world,
                             double fov_y_rad);

/// Sets near and far so that `bounds` fits between them: with d the depth of its centre along the
/// view direction, far = d + radius, near = d - radius but at least 1e-4 radii, so that an eye
/// inside the scene keeps what stands close to it (far is twice near if all of it lies behind the
/// eye).
void fit_clip_range(Camera& camera, const Sphere& bounds);

/// Puts points where a view sees them. Everything is made eye-relative in double first.
class Projection {
  public:
    explicit Projection(const View& view);

    /// View space: eye at the origin, y up, looking along -z.
    [[nodiscard]] glm::dvec3 to_view(const glm::dvec3& p_world) const {
        return view_from_world_ * (p_world - eye_world_);
    }
    /// Clip space without its z: (x, y, w) with w = -z_view; screen coordinates are x/w, y/w, in
    /// px, (0,0) the top left corner. Points with w < near are in front of the near plane.
    [[nodiscard]] glm::dvec3 to_clip(const glm::dvec3& p_world) const {
        const glm::dvec3 p_view = to_view(p_world);
        const double w = -p_view.z;
        return {
            focal_px_ * p_view.x + center_px_.x * w, center_px_.y * w - focal_px_ * p_view.y, w};
    }
    /// The unit-depth direction through a point of the image, world space: eye + w * direction
    /// lies at distance w along the view direction and projects to (x_px, y_px).
    [[nodiscard]] glm::dvec3 ray_world(double x_px, double y_px) const;

    [[nodiscard]] const glm::dvec3& eye_world() const { return eye_world_; }
    [[nodiscard]] double focal_px() const { return focal_px_; }  ///< px per unit of x/w, both axes

  private:
    glm::dvec3 eye_world_;
    glm::dmat3 view_from_world_;
    double focal_px_;
    glm::dvec3 center_px_;
};

}  // namespace ink::scene
