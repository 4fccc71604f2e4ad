#include "raster/mesh/windows.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace ink::raster {

std::optional<Window> Window::of(const scene::Sphere& ball,
                                 const glm::dvec3& eye_world,
                                 double pixel) {
    // Snapped vertices move a part of a pixel.
    constexpr double kWider_px = 2;
    const glm::dvec3 way = ball.center_world - eye_world;
    const double distance = glm::length(way);
    const double radius = ball.radius * (1 + 1e-9) + kWider_px * pixel * distance;
    if (!(radius < distance)) return std::nullopt;
    Window window;
    window.axis_ = way / distance;
    window.sine_ = radius / distance;
    window.cosine_ = std::sqrt(1 - window.sine_ * window.sine_);
    window.nearest_ = distance - radius;
    return window;
}

bool Window::may_show(const scene::Sphere& ball, const glm::dvec3& eye_world) const {
    // Seen from the eye, the two balls are cones of half-angles a (the window's) and b. They meet
    // unless their axes are more than a + b apart: with d the way to the ball, r its radius,
    //   axis . d >= |d| cos(a + b) = cos a sqrt(d . d - r r) - sin a r.
    const glm::dvec3 d = ball.center_world - eye_world;
    const double square = glm::dot(d, d);
    const double tangent2 = square - ball.radius * ball.radius;
    if (!(tangent2 > 0)) return true;  // the eye is in the ball
    if (std::sqrt(square) + ball.radius < nearest_) return false;
    return glm::dot(axis_, d) >= cosine_ * std::sqrt(tangent2) - sine_ * ball.radius;
}

std::optional<std::vector<Window>> find_windows(const scene::Surface& surface,
                                                const scene::Clusters& clusters,
                                                const scene::Solid& solid,
                                                const scene::View& view) {
    const glm::dvec3& eye = view.camera.eye_world;
    const double pixel = 1 / scene::Projection(view).focal_px();
    std::vector<Window> windows;
    std::vector<glm::dvec3> rim;
    for (const scene::Hole& hole :
         std::span(clusters.holes).subspan(solid.first_hole, solid.hole_count)) {
        rim.clear();
        for (std::size_t i = 0; i < hole.corner_count; ++i)
            rim.push_back(surface.p_world[clusters.rims[hole.first_corner + i]]);
        if (hole.is_covered && !scene::may_face(hole, rim, eye)) continue;
        const std::optional<Window> window = Window::of(hole.bounds, eye, pixel);
        if (!window) return std::nullopt;
        windows.push_back(*window);
    }
    return windows;
}

}  // namespace ink::raster
