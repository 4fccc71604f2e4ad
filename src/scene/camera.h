#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "scene/viewpoint.h"

namespace ink::scene {

/// A ball that holds a scene, world space. `radius` 0 for an empty scene.
struct Sphere {
    glm::dvec3 center_world{0};
    double radius = 0;
};

/// How lines of sight run: through the eye, or all one way.
enum class ProjectionKind { perspective, parallel };
inline constexpr std::array<std::string_view, 2> kProjectionNames{"perspective", "parallel"};

/// A camera: right-handed, y up, looks along -z of its own view space (glTF's convention). A
/// pinhole, or parallel: then all lines of sight run along -z, and the eye is no more than the
/// place from which near and far are measured.
struct Camera {
    std::string name;
    glm::dvec3 eye_world{0, 0, 1};
    /// Rotates eye-relative world vectors into view space: rows are right, up and back.
    glm::dmat3 view_from_world{1};
    /// Of a parallel camera: its direction of sight as given, target less eye, of any length.
    /// view_from_world has it rounded, which may turn faces that are edge-on. 0: only there.
    glm::dvec3 sight_world{0};
    double fov_y_rad = 0.6981317007977318;  ///< 40 degrees, vertical
    double height_world = 0;                ///< seen by a parallel camera; 0: it is a pinhole
    double near = 0.01;                     ///< distance of the near plane along -z, > 0
    double far = 100;  ///< only scales depth encodings and z buffers; nothing is clipped there

    [[nodiscard]] bool is_parallel() const { return height_world > 0; }
    [[nodiscard]] ProjectionKind projection() const {
        return is_parallel() ? ProjectionKind::parallel : ProjectionKind::perspective;
    }
    /// By what facing and sides are decided.
    [[nodiscard]] Viewpoint viewpoint() const {
        if (!is_parallel()) return {eye_world, false};
        return {-glm::dvec3(view_from_world[0][2], view_from_world[1][2], view_from_world[2][2]),
                true,
                sight_world};
    }
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

/// How far along the view direction the middle of the ball lies.
[[nodiscard]] double middle_depth(const Camera& camera, const Sphere& bounds);

/// Sets near and far so that `bounds` fits between them: with d the depth of its centre along the
/// view direction, far = d + radius, near = d - radius but at least 1e-4 radii, so that an eye
/// inside the scene keeps what stands close to it (far is twice near if all of it lies behind the
/// eye).
void fit_clip_range(Camera& camera, const Sphere& bounds);

/// Lets a parallel camera stand before `bounds`, wherever along its line of sight it stood before
/// them; near and far go with it. The farther away, the fewer digits are left of what it sees. One
/// that stands among them, or behind, stays.
void stand_before(Camera& camera, const Sphere& bounds);

/// What a parallel camera is to see.
struct ParallelLook {
    glm::dvec3 target_world{0};
    glm::dvec3 way_world{0, 0, -1};  ///< from the eye to the target, as given
    glm::dvec3 up_world{0, 1, 0};
    double height_world = 0;  ///< round the target, > 0
};

/// A parallel camera that stands before `bounds` and sees that, near and far fitted. Eyes anywhere
/// before them on one line of sight make the same camera, bit for bit; one among them or behind
/// stands where it is. Throws as look_at does.
[[nodiscard]] Camera parallel_camera(const ParallelLook& look, const Sphere& bounds);

/// The camera itself if it has that projection, else one of that projection that stands and looks
/// as it does and sees as much at the middle of `bounds`, or at its near plane or a radius away if
/// that is further; near and far stay. A pinhole sees 1 to 170 degrees.
[[nodiscard]] Camera projected(ProjectionKind kind, const Camera& camera, const Sphere& bounds);

/// The same camera with so many columns and rows more, half of them on either side: the same focal
/// length in px and the same middle. Only its angle, or height, grows, as it belongs to more rows.
/// A view without pixels comes back as it is.
[[nodiscard]] View grown_view(const View& view, int more_px);

/// The view whose pixel centres are the pixel corners of `view`: grown by one, so that the centre
/// of its pixel (x, y) is the upper left corner of pixel (x, y) of `view`, (0, 0) to (width_px,
/// height_px).
[[nodiscard]] inline View corner_view(const View& view) {
    return grown_view(view, 1);
}

/// The w of Projection at a distance along the view direction.
[[nodiscard]] inline double w_of_depth(const Camera& camera, double depth) {
    if (!camera.is_parallel()) return depth;
    return camera.near * camera.far / (camera.near + camera.far - depth);
}

/// A change of 1/w that goes with a length along the line of sight: of_q / w + constant.
struct DepthSlope {
    double of_q = 0;      ///< in perspective
    double constant = 0;  ///< of a parallel camera

    friend DepthSlope operator*(double length, const DepthSlope& slope) {
        return {length * slope.of_q, length * slope.constant};
    }
};

/// Puts points where a view sees them. Everything is made eye-relative in double first.
///
/// 1/w is affine on the screen, larger where it is nearer. In perspective w is the depth, the
/// distance along the view direction. Of a parallel camera 1/w is affine in the depth, and w is the
/// depth at near and at far. It is above 0 up to the depth near + far.
class Projection {
  public:
    explicit Projection(const View& view);

    /// View space: eye at the origin, y up, looking along -z.
    [[nodiscard]] glm::dvec3 to_view(const glm::dvec3& p_world) const {
        return view_from_world_ * (p_world - eye_world_);
    }
    /// Clip space without its z: (x, y, w); screen coordinates are x/w, y/w, in px, (0,0) the top
    /// left corner. Points with w < near are in front of the near plane.
    [[nodiscard]] glm::dvec3 to_clip(const glm::dvec3& p_world) const {
        const glm::dvec3 p_view = to_view(p_world);
        const double depth = -p_view.z;
        if (is_parallel_) {
            const double w = w_of(depth);
            return {(focal_px_ * p_view.x + center_px_.x) * w,
                    (center_px_.y - focal_px_ * p_view.y) * w,
                    w};
        }
        return {focal_px_ * p_view.x + center_px_.x * depth,
                center_px_.y * depth - focal_px_ * p_view.y,
                depth};
    }
    /// (x, y, h, q): the same, linear along any line of the world. Screen coordinates are x/h and
    /// y/h, and 1/w is q/h.
    [[nodiscard]] glm::dvec4 to_homogeneous(const glm::dvec3& p_world) const {
        if (!is_parallel_) return {to_clip(p_world), 1};
        const glm::dvec3 p_view = to_view(p_world);
        return {focal_px_ * p_view.x + center_px_.x,
                center_px_.y - focal_px_ * p_view.y,
                1,
                (near_plus_far_ + p_view.z) / near_far_};
    }
    [[nodiscard]] double w_of(double depth) const {
        return is_parallel_ ? near_far_ / (near_plus_far_ - depth) : depth;
    }
    [[nodiscard]] double depth_of(double w) const {
        return is_parallel_ ? near_plus_far_ - near_far_ / w : w;
    }
    /// The direction of sight through a point of the image, world space, as long as its depth is 1.
    [[nodiscard]] glm::dvec3 ray_world(double x_px, double y_px) const;
    /// Where that line of sight has depth 0: the eye, in perspective.
    [[nodiscard]] glm::dvec3 ray_begin_world(double x_px, double y_px) const;
    /// The point that is seen at (x_px, y_px) at this depth.
    [[nodiscard]] glm::dvec3 at(double x_px, double y_px, double depth) const {
        return ray_begin_world(x_px, y_px) + depth * ray_world(x_px, y_px);
    }
    /// The line of sight that ends at a point.
    [[nodiscard]] SightLine sight_to(const glm::dvec3& p_world) const {
        if (!is_parallel_) return {eye_world_, p_world - eye_world_};
        const glm::dvec3 way = -to_view(p_world).z * viewpoint_.at_world;
        return {p_world - way, way};
    }

    [[nodiscard]] bool is_parallel() const { return is_parallel_; }
    [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
    [[nodiscard]] const glm::dvec3& eye_world() const { return eye_world_; }
    [[nodiscard]] double focal_px() const { return focal_px_; }  ///< px per unit of x/w, both axes
    /// Pixels that a length across the line of sight takes at w.
    [[nodiscard]] double px_per_world(double w) const {
        return is_parallel_ ? focal_px_ : focal_px_ / w;
    }
    /// By how much 1/w changes over as much depth as a pixel is wide.
    [[nodiscard]] DepthSlope q_per_px() const {
        if (is_parallel_) return {0, 1 / (focal_px_ * near_far_)};
        return {1 / focal_px_, 0};
    }
    /// From where a pinhole of 40 degrees would see as much as a parallel camera; 0 in perspective.
    [[nodiscard]] double parallel_distance() const;
    /// By how much 1/w changes over a depth as long as the distance from the eye, which for a
    /// parallel camera is parallel_distance().
    [[nodiscard]] DepthSlope q_per_distance() const {
        if (is_parallel_) return {0, parallel_distance() / near_far_};
        return {1, 0};
    }

  private:
    Viewpoint viewpoint_;
    glm::dvec3 eye_world_;
    glm::dmat3 view_from_world_;
    bool is_parallel_;
    double near_plus_far_, near_far_;  ///< sum and product
    double focal_px_;                  ///< px per unit of x/w, or of x if parallel; both axes
    glm::dvec3 center_px_;
};

}  // namespace ink::scene
