#include "buffers/surface_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <glm/trigonometric.hpp>
#include <utility>

namespace ink::buffers {
namespace {

bool is_same_view(const scene::View& a, const scene::View& b) {
    return a.width_px == b.width_px && a.height_px == b.height_px &&
           a.camera.eye_world == b.camera.eye_world &&
           a.camera.view_from_world == b.camera.view_from_world &&
           a.camera.viewpoint() == b.camera.viewpoint() &&
           a.camera.fov_y_rad == b.camera.fov_y_rad &&
           a.camera.height_world == b.camera.height_world && a.camera.near == b.camera.near &&
           a.camera.far == b.camera.far;
}

/// Objects, modulo 64, of which some corner is not where or how it was. The same triangles.
std::uint64_t moved_objects(const scene::Surface& a, const scene::Surface& b) {
    std::uint64_t moved = 0;
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        for (const std::uint32_t corner : a.triangles[t]) {
            const bool is_same = a.p_world[corner] == b.p_world[corner] &&
                                 (a.n_world.empty() || a.n_world[corner] == b.n_world[corner]);
            if (!is_same) moved |= std::uint64_t{1} << (a.object[t] % 64);
        }
    }
    return moved;
}

}  // namespace

std::shared_ptr<const scene::Surface> SurfaceInputs::flattened(
    const scene::PreparedScene& scene) const {
    if (reads_ == Reads::positions) return scene.surface();
    return scene.surface(params_.normals, glm::radians(params_.crease_deg));
}

void SurfaceInputs::prepare(const scene::PreparedScene& scene) {
    lay_out(scene);
    has_moved_ = false;
}

void SurfaceInputs::lay_out(const scene::PreparedScene& scene) {
    // With its surface, which takes less time to make and goes sooner.
    const std::string name =
        reads_ == Reads::positions
            ? "lanes"
            : fmt::format("lanes {} {}", static_cast<int>(params_.normals), params_.crease_deg);
    const auto laid_out = scene.get(name, [&] {
        const auto surface = flattened(scene);
        return std::pair(surface, raster::LaneMesh(*surface));
    });
    surface_ = laid_out->first;
    // A copy: where methods draw in turns, one that is shared would be in the caches, and the mesh
    // of a method that has its own would not.
    mesh_ = laid_out->second;
    bounds_ = scene.bounds();
    posed_hash_ = scene.hash();
    last_ = {};
}

Posed SurfaceInputs::pose(const scene::PreparedScene& scene) {
    const std::uint64_t hash = scene.hash();
    if (hash == posed_hash_) return Posed::still;
    has_moved_ = true;
    // Which corners share a normal may change with the dihedral deviation between faces, so a moved
    // scene is flattened anew; its clusters stay if that has not happened.
    auto moved = flattened(scene);
    if (moved->triangles != surface_->triangles ||
        moved->p_world.size() != surface_->p_world.size()) {
        lay_out(scene);
        return Posed::anew;
    }
    moved_objects_ |= moved_objects(*surface_, *moved);
    mesh_.update(*moved);
    surface_ = std::move(moved);
    bounds_ = scene.bounds();
    posed_hash_ = hash;
    return Posed::moved;
}

void SurfaceInputs::see(const method::Frame& frame) {
    const scene::Camera& camera = frame.view.camera;
    const raster::DepthRange range = method::depth_range(params_.depth_range, camera, bounds_);
    // What a watertight solid hides depends on the scene's ball, too.
    const bool is_range_same = range.near == range_.near && range.far == range_.far &&
                               bounds_.center_world == seen_bounds_.center_world &&
                               bounds_.radius == seen_bounds_.radius;
    seen_bounds_ = bounds_;
    keeps_still_ = frame.skips.has(raster::Skip::temporal_reuse) && has_moved_;
    const scene::View view = sampled_view(frame.view, params_.samples);
    is_still_ = keeps_still_ && last_.is_kept && is_range_same && is_same_view(view, view_);
    view_ = view;
    range_ = range;
}

raster::MeshInput SurfaceInputs::mesh_input(const method::Frame& frame) const {
    raster::MeshInput input;
    input.mesh = &mesh_;
    input.view = view_;
    input.bounds = bounds_;
    input.threads = frame.threads;
    input.skips = frame.skips;
    input.may_keep_still = keeps_still_;
    if (is_still_) input.moved_objects = moved_objects_;
    return input;
}

LinearChannels SurfaceInputs::linear_channels() const {
    const double span = range_.far - range_.near;
    LinearChannels channels;
    channels.depth.base = -range_.near / span;
    channels.depth.per_q = range_.near * (range_.far / span);
    const glm::mat3 view_from_world(view_.camera.view_from_world);
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis)
            channels.normal[i].per_normal[axis] = view_from_world[axis][i];
    }
    return channels;
}

glm::mat3 SurfaceInputs::view_from_world() const {
    return glm::mat3(view_.camera.view_from_world);
}

void SurfaceInputs::finish(const raster::MeshResult& result, edge::EdgeImage& out) {
    assert(result.still.empty() || is_still_ || std::ranges::count(result.still, 1) == 0);
    const raster::TileGrid grid{view_.width_px, view_.height_px, 0};
    for (std::size_t tile = 0; tile < result.still.size(); ++tile) {
        if (result.still[tile] == 0) continue;
        const raster::PixelRect rect = grid.own(static_cast<int>(tile));
        // The last samples of a corner pass have no pixel.
        const int x1 = std::min(rect.x1, out.width_px());
        const int y1 = std::min(rect.y1, out.height_px());
        if (x1 <= rect.x0) continue;
        for (int y = rect.y0; y < y1; ++y)
            std::copy_n(last_.image.row(y) + rect.x0, x1 - rect.x0, out.row(y) + rect.x0);
    }
    last_.is_kept = keeps_still_;
    if (keeps_still_) last_.image = out;
    moved_objects_ = 0;
}

}  // namespace ink::buffers
