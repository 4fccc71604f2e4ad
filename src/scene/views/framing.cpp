#include "scene/views/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <set>

#include "core/error.h"
#include "core/param.h"

namespace ink::scene {
namespace {

/// The least and greatest place along one axis of the image at which the sides of the frame,
/// sloping by `slope` per unit of depth, still hold all points.
struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double across, double back, double slope) {
        low = std::min(low, across - slope * back);
        high = std::max(high, across + slope * back);
    }
    /// How far back the eye must be for this axis.
    [[nodiscard]] double back(double slope) const { return size() / (2 * slope); }
    [[nodiscard]] double size() const { return high - low; }
    [[nodiscard]] double middle() const { return (low + high) / 2; }
};

/// The camera that sees the points' box across its view direction.
void fit_parallel(std::span<const glm::dvec3> points,
                  double width_over_height,
                  double fill,
                  const Sphere& bounds,
                  Camera& camera) {
    Extent x;
    Extent y;
    for (const auto& p_world : points) {
        const glm::dvec3 p = camera.view_from_world * p_world;
        x.take(p.x, 0, 0);
        y.take(p.y, 0, 0);
    }
    camera.height_world = std::max(y.size(), x.size() / width_over_height) / fill;
    const double back = (camera.view_from_world * bounds.center_world).z + 2 * bounds.radius;
    camera.eye_world =
        glm::transpose(camera.view_from_world) * glm::dvec3(x.middle(), y.middle(), back);
}

}  // namespace

std::vector<glm::dvec3> placed_points(const Scene& scene) {
    std::vector<glm::dvec3> points;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const std::vector<bool> is_used = used_vertices(mesh);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            if (is_used[i]) points.push_back(to_world(instance, mesh.positions[i]));
        }
    }
    return points;
}

glm::dvec3 fitted_eye(std::span<const glm::dvec3> points,
                      const glm::dmat3& view_from_world,
                      const Frame& frame) {
    assert(!points.empty());
    const double slope_y = std::tan(frame.fov_y_rad / 2) * frame.fill;
    const double slope_x = slope_y * frame.width_over_height;
    Extent x;
    Extent y;
    for (const auto& p_world : points) {
        const glm::dvec3 p = view_from_world * p_world;
        x.take(p.x, p.z, slope_x);
        y.take(p.y, p.z, slope_y);
    }
    const double back = std::max(x.back(slope_x), y.back(slope_y));
    return glm::transpose(view_from_world) * glm::dvec3(x.middle(), y.middle(), back);
}

Camera framed(Camera camera,
              std::span<const glm::dvec3> points,
              double width_over_height,
              double fill,
              const Scene& scene) {
    const bool is_one_place =
        std::ranges::all_of(points, [&](const auto& p) { return p == points[0]; });
    if (is_one_place) return camera;
    const Sphere bounds = bounding_sphere(scene);
    if (camera.is_parallel()) {
        fit_parallel(points, width_over_height, fill, bounds, camera);
    } else {
        const Frame frame{camera.fov_y_rad, width_over_height, fill};
        camera.eye_world = fitted_eye(points, camera.view_from_world, frame);
    }
    fit_clip_range(camera, bounds);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& p_world : placed_points(scene)) {
        const double depth = -(camera.view_from_world * (p_world - camera.eye_world)).z;
        if (depth > camera.near) nearest = std::min(nearest, depth);
    }
    // The eye may stand inside the scene's ball, before everything: then the ball says little.
    constexpr double kAir = 0.99;
    if (nearest < camera.far) camera.near = std::max(camera.near, nearest * kAir);
    return camera;
}

Scene only_objects(const Scene& scene, std::span<const std::string> names) {
    Scene result = scene;
    result.animation.reset();
    std::set<std::string> known;
    for (const Instance& instance : scene.instances)
        known.insert(instance.name);
    for (const std::string& name : names) {
        if (known.count(name) != 0) continue;
        throw core::Error(scene.name,
                          fmt::format("it has no object '{}'", name),
                          core::known_names({known.begin(), known.end()}, name));
    }
    std::erase_if(result.instances, [&](const Instance& instance) {
        return std::ranges::find(names, instance.name) == names.end();
    });
    return result;
}

}  // namespace ink::scene
