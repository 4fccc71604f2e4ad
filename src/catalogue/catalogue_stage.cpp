#include "catalogue/catalogue_stage.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "catalogue/shapes.h"
#include "scene/views/framing.h"

namespace ink::catalogue {
namespace {

constexpr double kWidthOverHeight = 16.0 / 9.0;
constexpr double kFill = 0.92;  ///< of the frame, by the scene

glm::dmat4 snapped_columns(const glm::dmat4& m) {
    glm::dmat4 result(1);
    for (int column = 0; column < 4; ++column) {
        result[column] = glm::dvec4(snapped(glm::dvec3(m[column])), m[column].w);
    }
    return result;
}

void add_default_lights(scene::Scene& scene, const scene::Sphere& bounds) {
    const auto around = [&](const glm::dvec3& direction) {
        return snapped(bounds.center_world + direction * bounds.radius);
    };
    scene.lights.push_back({around({-1.25, 2, 2}), glm::vec3(0.875F), 0});
    scene.lights.push_back({around({2, 0.5, 1}), {0.75F, 0.5F, 0.25F}, 2.5 * bounds.radius});
}

}  // namespace

glm::dmat4 placed(const Pose& pose) {
    const glm::dvec3 turn_rad = glm::radians(pose.turn_deg);
    glm::dmat4 m = glm::translate(glm::dmat4(1), pose.at);
    m = glm::rotate(m, turn_rad.y, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, turn_rad.x, glm::dvec3(1, 0, 0));
    m = glm::rotate(m, turn_rad.z, glm::dvec3(0, 0, 1));
    return snapped_columns(glm::scale(m, pose.scale));
}

std::uint32_t Stage::mesh(std::string name, scene::Mesh mesh) {
    mesh.name = std::move(name);
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(scene_.meshes.size() - 1);
}

void Stage::place(std::uint32_t mesh, std::string name, const glm::dmat4& world_from_object) {
    scene_.instances.push_back({mesh, snapped_columns(world_from_object), std::move(name)});
}

void Stage::place(std::uint32_t mesh, std::string name, const Pose& pose) {
    place(mesh, std::move(name), placed(pose));
}

void Stage::add_at(const glm::dmat4& world_from_object, std::string name, scene::Mesh mesh) {
    const auto number = this->mesh(name, std::move(mesh));
    place(number, std::move(name), world_from_object);
}

void Stage::view(const Shot& shot) {
    const double turn_rad = glm::radians(shot.turn_deg);
    const double height_rad = glm::radians(shot.height_deg);
    const glm::dvec3 back = snapped({std::sin(turn_rad) * std::cos(height_rad),
                                     std::sin(height_rad),
                                     std::cos(turn_rad) * std::cos(height_rad)});
    const double fov_rad = glm::radians(shot.fov_deg);
    scene::Camera camera = scene::look_at(back, glm::dvec3(0), {0, 1, 0}, fov_rad);
    camera.name = shot.name;
    camera.eye_world = snapped(scene::fitted_eye(
        scene::placed_points(scene_), camera.view_from_world, {fov_rad, kWidthOverHeight, kFill}));
    scene_.cameras.push_back(camera);
    nears_.push_back(0);
}

void Stage::view(const EyeShot& shot) {
    scene::Camera camera = scene::look_at(
        shot.eye_world, shot.target_world, glm::dvec3(0, 1, 0), glm::radians(shot.fov_deg));
    camera.name = shot.name;
    scene_.cameras.push_back(camera);
    nears_.push_back(shot.near);
}

scene::Scene Stage::finish(std::initializer_list<Shot> shots,
                           std::initializer_list<EyeShot> eye_shots) {
    for (const Shot& shot : shots)
        view(shot);
    for (const EyeShot& shot : eye_shots)
        view(shot);
    const scene::Sphere bounds = scene::bounding_sphere(scene_);
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) {
        scene::fit_clip_range(scene_.cameras[i], bounds);
        if (nears_[i] > 0) scene_.cameras[i].near = nears_[i];
    }
    if (scene_.lights.empty()) add_default_lights(scene_, bounds);
    return std::move(scene_);
}

}  // namespace ink::catalogue
