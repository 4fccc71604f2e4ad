#include "methods/surface_inputs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "core/parallel.h"

namespace ink::methods {
namespace {

constexpr std::size_t kRun = 4096;

/// A triangle cut at a plane: up to four corners, in order.
struct Polygon {
    std::array<std::uint32_t, 4> corners{};
    std::uint32_t count = 0;

    void add(std::uint32_t corner) { corners[count++] = corner; }
};

}  // namespace

void for_runs(std::size_t count,
              int threads,
              const std::function<void(std::size_t, std::size_t)>& body) {
    core::parallel_for((count + kRun - 1) / kRun, threads, [&](std::size_t run) {
        body(run * kRun, std::min(count, (run + 1) * kRun));
    });
}

SurfaceInputs::SurfaceInputs(const InputParams& params) : params_(params) {}

void SurfaceInputs::prepare(const scene::Scene& scene) {
    surface_ = scene::flatten(scene, params_.normals, glm::radians(params_.crease_deg));
    bounds_ = scene::bounding_sphere(scene);
    posed_hash_ = scene::scene_hash(scene);
}

void SurfaceInputs::pose(const scene::Scene& scene) {
    // Which corners share a normal may change with the bend between faces, so a moved scene is
    // flattened anew rather than its old corners moved.
    if (scene::scene_hash(scene) != posed_hash_) prepare(scene);
}

void SurfaceInputs::see(const Frame& frame) {
    camera_ = frame.view.camera;
    range_ = depth_range(params_.depth_range, camera_, bounds_);
    facing_ = scene::facings(surface_, camera_.eye_world);
    transform(frame);
}

void SurfaceInputs::transform(const Frame& frame) {
    const std::size_t count = surface_.p_world.size();
    p_clip_.resize(count);
    n_view_.resize(count);
    const scene::Projection projection(frame.view);
    const glm::mat3 view_from_world(camera_.view_from_world);
    std::atomic<bool> crosses_near = false;
    for_runs(count, frame.threads, [&](std::size_t first, std::size_t last) {
        double nearest = camera_.near;
        for (std::size_t i = first; i < last; ++i) {
            p_clip_[i] = projection.to_clip(surface_.p_world[i]);
            n_view_[i] = view_from_world * surface_.n_world[i];
            nearest = std::min(nearest, p_clip_[i].z);
        }
        if (nearest < camera_.near) crosses_near = true;
    });
    is_cut_ = crosses_near;
    if (is_cut_) cut_at_near(camera_.near);
}

/// Both neighbours of an edge compute its cut from the same end, so they get the same bits.
void SurfaceInputs::cut_at_near(double near) {
    cut_triangles_.clear();
    cut_facing_.clear();
    const auto is_inside = [&](std::uint32_t v) { return p_clip_[v].z >= near; };
    const auto cut = [&](std::uint32_t inside, std::uint32_t outside) {
        const glm::dvec3 a = p_clip_[inside];
        const glm::dvec3 b = p_clip_[outside];
        const double t = (a.z - near) / (a.z - b.z);
        const glm::dvec3 p = a + t * (b - a);
        const glm::vec3 n = glm::mix(n_view_[inside], n_view_[outside], static_cast<float>(t));
        p_clip_.emplace_back(p.x, p.y, near);
        n_view_.push_back(n);
        return static_cast<std::uint32_t>(p_clip_.size() - 1);
    };
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
        const scene::Triangle& triangle = surface_.triangles[t];
        Polygon polygon;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i];
            const std::uint32_t to = triangle[(i + 1) % 3];
            if (is_inside(from)) polygon.add(from);
            if (is_inside(from) != is_inside(to)) {
                polygon.add(is_inside(from) ? cut(from, to) : cut(to, from));
            }
        }
        for (std::uint32_t i = 2; i < polygon.count; ++i) {
            cut_triangles_.push_back(
                {polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]});
            cut_facing_.push_back(facing_[t]);
        }
    }
}

void SurfaceInputs::gather_channels(const DepthCarrier& carrier,
                                    int threads,
                                    std::vector<float>& front,
                                    std::vector<float>& back) const {
    front.resize(4 * corner_count());
    back.resize(front.size());
    for_runs(corner_count(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const float depth = carrier.at_vertex(w(i));
            front[4 * i] = back[4 * i] = depth;
            for (int k = 0; k < 3; ++k) {
                front[4 * i + 1 + k] = n_view_[i][k];
                back[4 * i + 1 + k] = -n_view_[i][k];
            }
        }
    });
}

raster::PassInput SurfaceInputs::pass_input() const {
    raster::PassInput input;
    input.p_clip = p_clip_;
    input.triangles = is_cut_ ? std::span(cut_triangles_) : std::span(surface_.triangles);
    input.facing = is_cut_ ? std::span(cut_facing_) : std::span(facing_);
    input.near = camera_.near;
    input.far = camera_.far;
    return input;
}

}  // namespace ink::methods
