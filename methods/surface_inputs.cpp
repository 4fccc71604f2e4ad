#include "methods/surface_inputs.h"

#include <algorithm>
#include <atomic>
#include <glm/trigonometric.hpp>

#include "core/parallel.h"

namespace ink::methods {
namespace {

constexpr std::size_t kRun = 4096;

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
    vertices_.p_clip.resize(count);
    vertices_.n_view.resize(count);
    const scene::Projection projection(frame.view);
    const glm::mat3 view_from_world(camera_.view_from_world);
    std::atomic<bool> needs_cutting = false;
    for_runs(count, frame.threads, [&](std::size_t first, std::size_t last) {
        bool found = false;
        for (std::size_t i = first; i < last; ++i) {
            const glm::dvec3 p = projection.to_clip(surface_.p_world[i]);
            vertices_.p_clip[i] = p;
            vertices_.n_view[i] = view_from_world * surface_.n_world[i];
            found |= needs_cut(p, camera_.near);
        }
        if (found) needs_cutting = true;
    });
    is_cut_ = needs_cutting;
    if (is_cut_) cut_triangles(surface_.triangles, facing_, camera_.near, vertices_, cut_);
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
                front[4 * i + 1 + k] = vertices_.n_view[i][k];
                back[4 * i + 1 + k] = -vertices_.n_view[i][k];
            }
        }
    });
}

raster::PassInput SurfaceInputs::pass_input() const {
    raster::PassInput input;
    input.p_clip = vertices_.p_clip;
    input.triangles = is_cut_ ? std::span(cut_.triangles) : std::span(surface_.triangles);
    input.facing = is_cut_ ? std::span(cut_.facing) : std::span(facing_);
    input.near = camera_.near;
    input.far = camera_.far;
    return input;
}

}  // namespace ink::methods
