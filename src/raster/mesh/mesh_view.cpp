#include "raster/mesh/mesh_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>

#include "core/parallel.h"

namespace ink::raster {
namespace {

/// Whether no face of a cluster that is turned away is seen.
bool hides_backs(const SolidView& solid,
                 const scene::Cluster& cluster,
                 const scene::Viewpoint& eye) {
    return solid.hides_backs && std::ranges::none_of(solid.windows, [&](const Window& window) {
               return window.may_show(cluster.bounds, eye);
           });
}

/// Coarse steps of distance, twice: clusters that face the eye, then those turned away.
constexpr std::size_t kSteps = 32;

/// Clusters next to each other that one thread puts in order.
struct Slice {
    std::size_t first = 0;
    std::size_t end = 0;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0;
    std::array<std::uint32_t, 2 * kSteps> next{};  ///< per step the number, later the next place
};

std::vector<Slice> slices_of(std::size_t clusters, int threads) {
    const std::size_t count = slice_count(clusters, threads);
    std::vector<Slice> slices(count);
    for (std::size_t i = 0; i < count; ++i) {
        slices[i].first = i * clusters / count;
        slices[i].end = (i + 1) * clusters / count;
    }
    return slices;
}

/// From numbers per step and slice to places: by step, within one in the order of the mesh.
void number_places(std::vector<Slice>& slices) {
    std::uint32_t place = 0;
    for (std::size_t step = 0; step < 2 * kSteps; ++step) {
        for (Slice& slice : slices) {
            const std::uint32_t count = slice.next[step];
            slice.next[step] = place;
            place += count;
        }
    }
}

/// The windows of a solid that is watertight when its holes are covered, of eyes outside its ball:
/// a covered hole whose fan is turned away lets nothing be seen. Nothing if a hole's ball holds the
/// eye.
std::optional<std::vector<Window>> find_windows(const scene::Surface& surface,
                                                const scene::Clusters& clusters,
                                                const scene::Solid& solid,
                                                const scene::View& view) {
    const scene::Viewpoint eye = view.camera.viewpoint();
    const double pixel = 1 / scene::Projection(view).px_per_world(1);
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

}  // namespace

std::vector<SolidView> view_solids(const MeshInput& input) {
    const scene::Camera& camera = input.view.camera;
    const auto& solids = input.mesh->clusters().solids;
    std::vector<SolidView> views(solids.size());
    const auto depth_of = [&](const scene::Sphere& ball) {
        return -(camera.view_from_world * (ball.center_world - camera.eye_world)).z;
    };
    // A near plane fitted to the scene's own ball touches it at most, but for rounding.
    const bool is_all_uncut =
        input.bounds.radius > 0 &&
        depth_of(input.bounds) - input.bounds.radius >= camera.near - 1e-9 * input.bounds.radius;
    // A front hides the back behind it only if it is drawn, and neither is moved.
    const bool keeps_order = input.cull != Cull::front && !input.offset.is_any();
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const scene::Sphere& ball = solids[i].bounds;
        const double radius = ball.radius * (1 + 1e-6);
        const bool is_outside =
            camera.is_parallel() || glm::length(ball.center_world - camera.eye_world) > radius;
        const double depth = depth_of(ball);
        const bool is_uncut =
            is_all_uncut || depth - radius > camera.near || depth + radius < camera.near;
        if (!keeps_order || !is_uncut || !is_outside) continue;
        views[i].hides_backs = solids[i].is_watertight;
        if (!solids[i].is_watertight_covered) continue;
        auto windows =
            find_windows(input.mesh->surface(), input.mesh->clusters(), solids[i], input.view);
        views[i].hides_backs = windows.has_value();
        if (windows) views[i].windows = std::move(*windows);
    }
    return views;
}

std::optional<Window> Window::of(const scene::Sphere& ball,
                                 const scene::Viewpoint& eye,
                                 double pixel) {
    // Snapped vertices move a part of a pixel.
    constexpr double kWider_px = 2;
    const glm::dvec3 way = eye.sight(ball.center_world);
    const double distance = glm::length(way);
    const double at_window = eye.is_direction ? 1 : distance;
    const double radius = ball.radius * (1 + 1e-9) + kWider_px * pixel * at_window;
    if (!eye.is_direction && !(radius < distance)) return std::nullopt;
    Window window;
    window.axis_ = way / distance;
    window.wide_ = {ball.center_world, radius};
    if (eye.is_direction) return window;
    window.sine_ = radius / distance;
    window.cosine_ = std::sqrt(1 - window.sine_ * window.sine_);
    window.nearest_ = distance - radius;
    return window;
}

bool Window::may_show(const scene::Sphere& ball, const scene::Viewpoint& eye) const {
    if (eye.is_direction) {
        const glm::dvec3 way = ball.center_world - wide_.center_world;
        const double along = glm::dot(axis_, way), reach = wide_.radius + ball.radius;
        return along >= -reach && glm::length(way - along * axis_) <= reach;
    }
    // Seen from the eye, the two balls are cones of half-angles a (the window's) and b. They meet
    // unless their axes are more than a + b apart: with d the way to the ball, r its radius,
    //   axis . d >= |d| cos(a + b) = cos a sqrt(d . d - r r) - sin a r.
    const glm::dvec3 d = eye.sight(ball.center_world);
    const double square = glm::dot(d, d);
    const double tangent2 = square - ball.radius * ball.radius;
    if (!(tangent2 > 0)) return true;  // the eye is in the ball
    if (std::sqrt(square) + ball.radius < nearest_) return false;
    return glm::dot(axis_, d) >= cosine_ * std::sqrt(tangent2) - sine_ * ball.radius;
}

std::size_t slice_count(std::size_t clusters, int threads) {
    constexpr std::size_t kLeast = 1024;
    return std::clamp<std::size_t>(
        clusters / kLeast, 1, static_cast<std::size_t>(std::max(threads, 1)));
}

ClusterOrder front_to_back(const MeshInput& input, const std::vector<SolidView>& solids) {
    ClusterOrder result;
    const auto& clusters = input.mesh->clusters().clusters;
    const scene::Camera& camera = input.view.camera;
    const scene::Viewpoint eye = camera.viewpoint();
    result.clusters.resize(clusters.size());
    result.is_late.resize(clusters.size());
    result.hides_backs.resize(clusters.size());
    if (clusters.empty()) return result;
    std::vector<Slice> slices = slices_of(clusters.size(), input.threads);
    const auto for_each_slice = [&](const auto& body) {
        core::parallel_for(slices.size(), input.threads, [&](std::size_t i) { body(slices[i]); });
    };
    std::vector<double> distances(clusters.size());
    for_each_slice([&](Slice& slice) {
        for (std::size_t i = slice.first; i < slice.end; ++i) {
            const glm::dvec3 way = clusters[i].bounds.center_world - camera.eye_world;
            distances[i] = eye.is_direction
                               ? glm::dot(way, eye.at_world)
                               : std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
            slice.nearest = std::min(slice.nearest, distances[i]);
            slice.farthest = std::max(slice.farthest, distances[i]);
            // Where the solid hides its backs it is not drawn at all.
            const bool is_hidden = hides_backs(solids[clusters[i].solid], clusters[i], eye);
            result.hides_backs[i] = is_hidden ? 1 : 0;
            result.is_late[i] = !is_hidden && scene::is_turned_away(clusters[i], eye) ? 1 : 0;
        }
    });
    double nearest = slices.front().nearest;
    double farthest = slices.front().farthest;
    for (const Slice& slice : slices) {
        nearest = std::min(nearest, slice.nearest);
        farthest = std::max(farthest, slice.farthest);
    }
    const double scale = farthest > nearest ? (kSteps - 1) / (farthest - nearest) : 0;
    std::vector<std::uint8_t> steps(clusters.size());
    for_each_slice([&](Slice& slice) {
        for (std::size_t i = slice.first; i < slice.end; ++i) {
            steps[i] = static_cast<std::uint8_t>((distances[i] - nearest) * scale);
            if (result.is_late[i] != 0) steps[i] = static_cast<std::uint8_t>(steps[i] + kSteps);
            ++slice.next[steps[i]];
        }
    });
    number_places(slices);
    for_each_slice([&](Slice& slice) {
        for (std::size_t i = slice.first; i < slice.end; ++i)
            result.clusters[slice.next[steps[i]]++] = static_cast<std::uint32_t>(i);
    });
    return result;
}

ImageSides::ImageSides(const ViewTransform& transform, const scene::View& view)
    : transform_(transform),
      near_(view.camera.near),
      right_px_(view.width_px + 1.0),
      below_px_(view.height_px + 1.0) {
    const auto& rows = transform.rows;
    const auto length = [&](double kx, double ky, double kw) {
        if (transform.is_parallel) kw = 0;
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            const double v = kx * rows[0][i] + ky * rows[1][i] + kw * rows[2][i];
            sum += v * v;
        }
        return std::sqrt(sum);
    };
    lengths_[0] = length(1, 0, 1);
    lengths_[1] = length(-1, 0, right_px_);
    lengths_[2] = length(0, 1, 1);
    lengths_[3] = length(0, -1, below_px_);
}

bool ImageSides::has_outside(const scene::Sphere& ball) const {
    glm::dvec3 p = transform_.to_clip(ball.center_world);
    if (transform_.is_parallel) p /= p.z;
    const double radius = ball.radius * (1 + 1e-9);
    return transform_.depth(ball.center_world) < near_ - radius ||
           p.x + p.z < -radius * lengths_[0] || right_px_ * p.z - p.x < -radius * lengths_[1] ||
           p.y + p.z < -radius * lengths_[2] || below_px_ * p.z - p.y < -radius * lengths_[3];
}

}  // namespace ink::raster
