#include "cli/place.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>

#include "scene/box.h"
#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::cli {
namespace {

std::string text_of(const glm::dvec3& p, int digits) {
    return fmt::format("{:.{}g},{:.{}g},{:.{}g}", p.x, digits, p.y, digits, p.z, digits);
}

nlohmann::ordered_json json_of(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

/// What a place is told by, in the file's coordinates.
struct Place {
    scene::Box box;
    glm::dvec3 center{0};
    double radius = 0;
};

Place place_of(const scene::Scene& scene) {
    const scene::Box box = scene::box_of(scene::flatten(scene).p_world);
    const scene::Sphere sphere = scene::bounding_sphere(scene);
    return {{box.low + scene.origin, box.high + scene.origin},
            sphere.center_world + scene.origin,
            sphere.radius};
}

/// On the line of sight, as far away as the centre is.
glm::dvec3 target_of(const scene::Camera& camera, const scene::Sphere& sphere) {
    const double away = glm::distance(camera.eye_world, sphere.center_world);
    return camera.eye_world -
           (away > 0 ? away : sphere.radius) * glm::row(camera.view_from_world, 2);
}

}  // namespace

void print_up(const std::string& scene, harness::UpAxis up) {
    if (up != harness::UpAxis::y) fmt::print(stderr, "inkbench: {}: {} is up\n", scene, name(up));
}

void print_notes(const harness::SceneViews& scene_views) {
    const scene::Scene& scene = scene_views.scene;
    if (scene_views.has_named_views) print_up(scene.name, scene_views.up);
    print_not_heeded(scene.name, scene.file.notes);
}

void print_not_heeded(const std::string& scene, const std::vector<std::string>& notes) {
    if (notes.empty()) return;
    fmt::print(stderr, "inkbench: {}: not heeded: {}\n", scene, fmt::join(notes, "; "));
}

std::string place_text(const harness::SceneViews& scene_views) {
    const scene::Scene& scene = scene_views.scene;
    const Place place = place_of(scene);
    const bool is_far = scene.origin != glm::dvec3(0);
    const auto text_of = [&](const glm::dvec3& p) { return cli::text_of(p, is_far ? 15 : 9); };
    std::string text;
    if (is_far) {
        text = fmt::format("origin {}, taken out of all coordinates before they became floats\n",
                           text_of(scene.origin));
    }
    const glm::dvec3 size = place.box.high - place.box.low;
    text += fmt::format(
        "box {} .. {} ({:.9g} x {:.9g} x {:.9g}), centre {}, radius "
        "{:.9g}\nup in views by name: {} (--up)\nviews, as options of a camera of your own:\n",
        text_of(place.box.low),
        text_of(place.box.high),
        size.x,
        size.y,
        size.z,
        text_of(place.center),
        place.radius,
        name(scene_views.up));
    const scene::Sphere sphere = scene::bounding_sphere(scene);
    for (const auto& [camera, width_px, height_px] : scene_views.views) {
        text += fmt::format(
            "  {}  --eye {} --target {} --up {} --{} {:.9g}\n",
            camera.name,
            text_of(camera.eye_world + scene.origin),
            text_of(target_of(camera, sphere) + scene.origin),
            text_of(glm::row(camera.view_from_world, 1)),
            camera.is_parallel() ? "parallel" : "fov",
            camera.is_parallel() ? camera.height_world : glm::degrees(camera.fov_y_rad));
    }
    int number = 0;
    for (const std::string& animation : scene.file.animation_names) {
        text += fmt::format(
            "animation {}: {}\n", number++, animation.empty() ? "(no name)" : animation);
    }
    for (const std::string& note : scene.file.notes)
        text += fmt::format("not heeded: {}\n", note);
    return text;
}

nlohmann::ordered_json place_json(const harness::SceneViews& scene_views) {
    const scene::Scene& scene = scene_views.scene;
    const Place place = place_of(scene);
    nlohmann::ordered_json json = {
        {"box", {{"low", json_of(place.box.low)}, {"high", json_of(place.box.high)}}},
        {"centre", json_of(place.center)},
        {"radius", place.radius},
        {"up", name(scene_views.up)},
        {"origin", json_of(scene.origin)},
        {"animations", scene.file.animation_names},
        {"not_heeded", scene.file.notes},
        {"cameras", nlohmann::ordered_json::object()}};
    const scene::Sphere sphere = scene::bounding_sphere(scene);
    for (const auto& [camera, width_px, height_px] : scene_views.views) {
        auto& of_camera = json["cameras"][camera.name];
        of_camera = {{"eye", json_of(camera.eye_world + scene.origin)},
                     {"target", json_of(target_of(camera, sphere) + scene.origin)},
                     {"up", json_of(glm::row(camera.view_from_world, 1))}};
        if (camera.is_parallel()) {
            of_camera["height"] = camera.height_world;
        } else {
            of_camera["fov_deg"] = glm::degrees(camera.fov_y_rad);
        }
    }
    return json;
}

}  // namespace ink::cli
