#include "entrants/view_files.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/whole_file.h"
#include "entrants/mesh_files.h"
#include "entrants/view_buffers.h"
#include "harness/out_folder.h"

namespace ink::entrants {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kDegPerRad = 180 / std::numbers::pi;

constexpr const char* kConventions =
    "World space is right-handed, y up; a place in it and the origin add up to the place in the "
    "model's file. View space has its origin at the eye, x right, y up, and "
    "looks along -z. Matrices are by rows and take column vectors: p_view = view_from_world "
    "(p_world, 1). clip_from_view is OpenGL's: x, y and z divided by w lie in -1..1. Pixel (0, 0) "
    "is the upper left one and its centre is at (0.5, 0.5): x_px = (x/w + 1) width / 2, y_px = (1 "
    "- y/w) height / 2. Square pixels; the field of view is vertical. Write an 8-bit image of this "
    "size with the lines of the view, as seen from the eye with hidden lines removed: light on "
    "dark, or dark on light.";

Json point(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

/// view_from_world as four rows.
Json view_matrix(const scene::Camera& camera) {
    const glm::dvec3 moved = camera.view_from_world * -camera.eye_world;
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) {
        rows.push_back({camera.view_from_world[0][row],
                        camera.view_from_world[1][row],
                        camera.view_from_world[2][row],
                        moved[row]});
    }
    rows.push_back({0, 0, 0, 1});
    return rows;
}

/// OpenGL's perspective matrix as four rows.
Json clip_matrix(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    const double f = 1 / std::tan(camera.fov_y_rad / 2);
    const double aspect = static_cast<double>(view.width_px) / view.height_px;
    const double depth = camera.near - camera.far;
    return {{f / aspect, 0, 0, 0},
            {0, f, 0, 0},
            {0, 0, (camera.far + camera.near) / depth, 2 * camera.far * camera.near / depth},
            {0, 0, -1, 0}};
}

}  // namespace

std::string view_json(const scene::Scene& scene, const scene::View& view, const ViewFiles& files) {
    const scene::Camera& camera = view.camera;
    const auto row = [&](int i) {
        return glm::dvec3(camera.view_from_world[0][i],
                          camera.view_from_world[1][i],
                          camera.view_from_world[2][i]);
    };
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const double ahead =
        std::max(glm::dot(camera.eye_world - bounds.center_world, row(2)), camera.near);
    const Json json = {{"format", "inkbench view 1"},
                       {"scene", scene.name},
                       {"view", camera.name},
                       {"width_px", view.width_px},
                       {"height_px", view.height_px},
                       {"origin", point(scene.origin)},
                       {"camera",
                        {{"eye", point(camera.eye_world)},
                         {"target", point(camera.eye_world - ahead * row(2))},
                         {"up", point(row(1))},
                         {"fov_y_deg", camera.fov_y_rad * kDegPerRad},
                         {"near", camera.near},
                         {"far", camera.far}}},
                       {"view_from_world", view_matrix(camera)},
                       {"clip_from_view", clip_matrix(view)},
                       {"files",
                        {{"obj", files.obj.string()},
                         {"glb", files.glb.string()},
                         {"buffers", files.buffers.string()},
                         {"ids", files.ids.string()}}},
                       {"conventions", kConventions}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ViewFiles write_meshes(const scene::Scene& scene, const fs::path& folder) {
    harness::make_out_folder(folder);
    ViewFiles files{folder / "mesh.obj", folder / "mesh.glb"};
    write_obj(scene, files.obj);
    write_glb(scene, files.glb);
    return files;
}

void write_view(const scene::Scene& scene,
                const scene::View& view,
                const ViewFiles& meshes,
                double crease_rad,
                const fs::path& folder) {
    harness::make_out_folder(folder);
    const ViewBuffers buffers = view_buffers(scene, view, crease_rad);
    write_buffers_exr(buffers, folder / "buffers.exr");
    write_object_ids(buffers, folder / "ids.png");
    const ViewFiles named{fs::relative(meshes.obj, folder),
                          fs::relative(meshes.glb, folder),
                          "buffers.exr",
                          "ids.png"};
    core::write_whole_file(folder / "camera.json", view_json(scene, view, named));
}

}  // namespace ink::entrants
