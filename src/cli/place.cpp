#include "cli/place.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glm/geometric.hpp>
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

/// A row of the rotation into view space: right, up or back.
glm::dvec3 axis(const scene::Camera& camera, int row) {
    const glm::dmat3& m = camera.view_from_world;
    return {m[0][row], m[1][row], m[2][row]};
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

Place place_of(const harness::SceneViews& scene_views) {
    const scene::Surface surface = scene::flatten(scene_views.scene);
    const scene::Sphere sphere = scene::bounding_sphere(scene_views.scene);
    Place place;
    place.origin = scene_views.scene.origin;
    place.animations = scene_views.scene.file.animation_names;
    place.not_heeded = scene_views.scene.file.notes;
    place.center_world = sphere.center_world;
    place.radius = sphere.radius;
    place.up = scene_views.up;
    scene::Box box;
    for (const glm::dvec3& p : surface.p_world)
        box.add(p);
    place.low_world = box.low;
    place.high_world = box.high;
    for (const scene::View& view : scene_views.views) {
        const scene::Camera& camera = view.camera;
        const double away = glm::distance(camera.eye_world, sphere.center_world);
        const double reach = away > 0 ? away : sphere.radius;
        place.cameras.push_back({camera.name,
                                 camera.eye_world,
                                 camera.eye_world - reach * axis(camera, 2),
                                 axis(camera, 1),
                                 glm::degrees(camera.fov_y_rad),
                                 camera.height_world});
    }
    for (glm::dvec3* p : {&place.low_world, &place.high_world, &place.center_world})
        *p += place.origin;
    for (Place::Camera& camera : place.cameras) {
        camera.eye_world += place.origin;
        camera.target_world += place.origin;
    }
    return place;
}

std::string as_text(const Place& place) {
    const glm::dvec3 size = place.high_world - place.low_world;
    const bool is_far = place.origin != glm::dvec3(0);
    const auto text_of = [&](const glm::dvec3& p) { return cli::text_of(p, is_far ? 15 : 9); };
    std::string text = fmt::format(
        "box {} .. {} ({:.9g} x {:.9g} x {:.9g}), centre {}, radius "
        "{:.9g}\nup in views by name: {} (--up)\nviews, as options of a camera of your own:\n",
        text_of(place.low_world),
        text_of(place.high_world),
        size.x,
        size.y,
        size.z,
        text_of(place.center_world),
        place.radius,
        name(place.up));
    if (is_far) {
        text = fmt::format("origin {}, taken out of all coordinates before they became floats\n",
                           text_of(place.origin)) +
               text;
    }
    for (const Place::Camera& camera : place.cameras) {
        const bool is_parallel = camera.height_world > 0;
        text += fmt::format("  {}  --eye {} --target {} --up {} --{} {:.9g}\n",
                            camera.name,
                            text_of(camera.eye_world),
                            text_of(camera.target_world),
                            text_of(camera.up_world),
                            is_parallel ? "parallel" : "fov",
                            is_parallel ? camera.height_world : camera.fov_deg);
    }
    for (std::size_t i = 0; i < place.animations.size(); ++i) {
        text += fmt::format("animation {}: {}\n",
                            i,
                            place.animations[i].empty() ? "(no name)" : place.animations[i]);
    }
    for (const std::string& note : place.not_heeded)
        text += fmt::format("not heeded: {}\n", note);
    return text;
}

nlohmann::ordered_json as_json(const Place& place) {
    nlohmann::ordered_json json = {
        {"box", {{"low", json_of(place.low_world)}, {"high", json_of(place.high_world)}}},
        {"centre", json_of(place.center_world)},
        {"radius", place.radius},
        {"up", name(place.up)},
        {"origin", json_of(place.origin)},
        {"animations", place.animations},
        {"not_heeded", place.not_heeded},
        {"cameras", nlohmann::ordered_json::object()}};
    for (const Place::Camera& camera : place.cameras) {
        json["cameras"][camera.name] = {{"eye", json_of(camera.eye_world)},
                                        {"target", json_of(camera.target_world)},
                                        {"up", json_of(camera.up_world)}};
        if (camera.height_world > 0) {
            json["cameras"][camera.name]["height"] = camera.height_world;
        } else {
            json["cameras"][camera.name]["fov_deg"] = camera.fov_deg;
        }
    }
    return json;
}

}  // namespace ink::cli
