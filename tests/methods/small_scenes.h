#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "methods/registry.h"
#include "scene/scene.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {

using scene::scene_of;

inline scene::Mesh cube_mesh() {
    return scene::unit_cube();
}

/// A square in y = 0, +-size, seen from above.
inline scene::Mesh floor_mesh(float size) {
    scene::Mesh mesh;
    mesh.positions = {{-size, 0, -size}, {size, 0, -size}, {size, 0, size}, {-size, 0, size}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
    return mesh;
}

/// A cube on a floor: contours, boundaries and creases, facets behind facets.
inline scene::Scene cube_on_floor() {
    scene::Scene scene = scene_of({cube_mesh(), floor_mesh(3)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {0, -1, 0});
    return scene;
}

inline scene::View view_from(
    const scene::Scene& scene,
    const glm::dvec3& eye_world,
    const glm::dvec3& target_world,
    std::pair<int, int> size_px,
    scene::ProjectionKind projection = scene::ProjectionKind::perspective) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    scene::View view;
    view.camera = scene::look_at(eye_world, target_world, {0, 1, 0}, 0.7);
    scene::fit_clip_range(view.camera, bounds);
    view.camera = scene::projected(projection, view.camera, bounds);
    view.width_px = size_px.first;
    view.height_px = size_px.second;
    return view;
}

/// What faces the eye from 4 away, its middle in the middle of the image.
inline scene::View face_on(int width_px, int height_px) {
    scene::View view;
    view.camera = scene::look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.7);
    view.width_px = width_px;
    view.height_px = height_px;
    return view;
}

/// A wall that faces the eye and fills the middle half of a 160 x 160 image: pixels 40..119.
struct Wall {
    scene::Scene scene;
    scene::View view;

    Wall() {
        scene::Mesh mesh;
        scene::add_quad(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        scene = scene_of({mesh});
        view = view_from(scene, {0, 0, 4}, {0, 0, 0}, {160, 160});
        view.camera.fov_y_rad = 2 * std::atan(0.5);
    }
};

/// A new method, prepared for a scene as it stands, which is to outlive it.
inline std::unique_ptr<method::Method> posed_method(const method::MethodInfo& info,
                                                    const core::ParamValues& values,
                                                    const scene::Scene& scene) {
    auto method = info.make(values);
    method->prepare(scene);
    method->pose(scene);
    return method;
}

/// What a method draws over garbage.
inline edge::EdgeImage image_by(method::Method& method, const method::Frame& frame) {
    edge::EdgeImage out(frame.view.width_px, frame.view.height_px, 0xab);
    method.draw(frame, out);
    return out;
}

/// The image of one frame by a new method.
inline edge::EdgeImage drawn(const method::MethodInfo& info,
                             const core::ParamValues& values,
                             const scene::Scene& scene,
                             const method::Frame& frame) {
    return image_by(*posed_method(info, values, scene), frame);
}
inline edge::EdgeImage drawn(const std::string& method,
                             const core::ParamValues& values,
                             const scene::Scene& scene,
                             const method::Frame& frame) {
    return drawn(find_method(method), values, scene, frame);
}

}  // namespace ink::methods
