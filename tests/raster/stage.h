#pragma once

#include <string>
#include <utility>
#include <vector>

#include "catalogue/catalogue.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/pass/pass.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {

/// The corners of a surface in a view's clip space.
inline std::vector<glm::dvec3> clip_places(const scene::Surface& surface, const scene::View& view) {
    const ViewTransform transform(view);
    std::vector<glm::dvec3> p_clip;
    for (const glm::dvec3& p : surface.p_world)
        p_clip.push_back(transform.to_clip(p));
    return p_clip;
}

/// What the plain pass takes of them, but triangles.
inline PassInput plain_input(const std::vector<glm::dvec3>& p_clip, const scene::View& view) {
    PassInput input;
    input.p_clip = p_clip;
    input.near = view.camera.near;
    input.far = view.camera.far;
    return input;
}

/// A scene of the catalogue, laid out, and its first view.
struct Stage {
    scene::Surface surface;
    LaneMesh mesh;
    scene::View view;

    /// The eye stands at `nearer` of its distance.
    Stage(const std::string& name, const std::pair<int, int>& size_px, double nearer) {
        const scene::Scene made = catalogue::make_catalogue_scene(name);
        surface = scene::flatten(made, scene::NormalSource::patch, 0.7);
        mesh = LaneMesh(surface);
        const scene::Sphere bounds = scene::bounding_sphere(made);
        view.camera = made.cameras.front();
        view.camera.eye_world =
            bounds.center_world + (view.camera.eye_world - bounds.center_world) * nearer;
        scene::fit_clip_range(view.camera, bounds);
        view.width_px = size_px.first;
        view.height_px = size_px.second;
    }
    [[nodiscard]] MeshInput mesh_input(int threads, const SkipSet& skips) const {
        MeshInput input;
        input.mesh = &mesh;
        input.view = view;
        input.threads = threads;
        input.skips = skips;
        return input;
    }
};

}  // namespace ink::raster
