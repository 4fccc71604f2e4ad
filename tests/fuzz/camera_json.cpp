// camera.json is JSON, and says where the camera is to the last bit, whatever the names.

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "entrants/view_files.h"
#include "tests/fuzz/fuzz.h"
#include "tests/scene/small_meshes.h"

namespace ink::fuzz {
namespace {

using Json = nlohmann::json;

std::string text(Feed& feed) {
    std::string result;
    for (int left = feed.whole(0, 12); left > 0; --left)
        result.push_back(static_cast<char>(feed.raw<std::uint8_t>()));
    return result;
}

glm::dvec3 point(Feed& feed) {
    const auto number = [&] {
        const auto value = static_cast<double>(feed.raw<float>());
        return std::isfinite(value) ? value : 0;
    };
    const double x = number();
    const double y = number();
    return {x, y, number()};
}

glm::dvec3 point(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

double largest(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

void check_camera(const Json& json, const scene::View& view) {
    const scene::Camera& camera = view.camera;
    const Json& said = json.at("camera");
    expect(json.at("width_px") == view.width_px && json.at("height_px") == view.height_px,
           "the size is the view's");
    expect(point(said.at("eye")) == camera.eye_world, "the eye is the camera's");
    expect(
        said.at("near").get<double>() == camera.near && said.at("far").get<double>() == camera.far,
        "near and far are the camera's");
    if (camera.is_parallel()) {
        expect(said.at("height").get<double>() == camera.height_world, "the height is its own");
        return;
    }
    const double fov_y_rad = said.at("fov_y_deg").get<double>() * std::numbers::pi / 180;
    expect(std::abs(fov_y_rad - camera.fov_y_rad) <= 1e-15 * 4, "the angle is the camera's");
    const Json& rows = json.at("view_from_world");
    expect(rows.size() == 4 && json.at("clip_from_view").size() == 4, "matrices have four rows");
    for (int row = 0; row < 3; ++row) {
        const Json& numbers = rows.at(static_cast<std::size_t>(row));
        const glm::dvec3 axis = point(numbers);
        for (int column = 0; column < 3; ++column)
            expect(axis[column] == camera.view_from_world[column][row], "axes are the camera's");
        const double at_eye = glm::dot(axis, camera.eye_world) + numbers.at(3).get<double>();
        expect(std::abs(at_eye) <= 1e-14 * (1 + largest(camera.eye_world)),
               "the eye is the origin of view space");
    }
}

/// A file that is read by others holds numbers, and no null in the place of one.
void expect_finite(const Json& json) {
    expect(!json.is_null(), "no number is missing");
    if (!json.is_structured()) return;
    for (const Json& part : json)
        expect_finite(part);
}

}  // namespace

void check_camera_json(Bytes bytes) {
    Feed feed(bytes);
    scene::Scene scene = scene::scene_of(scene::unit_cube());
    scene.name = text(feed);
    scene::View view;
    const glm::dvec3 eye = point(feed);
    const glm::dvec3 target = point(feed);
    const glm::dvec3 up = point(feed);
    const double fov_y_rad = feed.real(1e-3, std::numbers::pi - 1e-3);
    const auto camera = unless_refused([&] { return scene::look_at(eye, target, up, fov_y_rad); });
    if (!camera) return;
    view.camera = *camera;
    view.camera.name = text(feed);
    scene::fit_clip_range(view.camera, scene::bounding_sphere(scene));
    view.width_px = feed.whole(1, 16384);
    view.height_px = feed.whole(1, 16384);
    const entrants::ViewFiles files{text(feed), text(feed), text(feed), text(feed)};
    const std::string written = entrants::view_json(scene, view, files);
    const Json json = Json::parse(written, nullptr, false);
    expect(!json.is_discarded(), "camera.json is JSON");
    expect(json.at("format") == "inkbench view 1", "it says what it is");
    check_camera(json, view);
    expect_finite(json);
}

}  // namespace ink::fuzz
