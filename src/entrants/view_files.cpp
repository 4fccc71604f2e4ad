#include "entrants/view_files.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include <numbers>

#include "buffers/each_tile.h"
#include "buffers/id_pass.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "harness/images/view_images.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "scene/surface.h"

namespace ink::entrants {
namespace {

constexpr double kWeldEpsilon = 1e-4;  ///< of patches, as `ids` has it

core::Image<std::uint32_t> triangle_image(const scene::Scene& scene, const scene::View& view) {
    core::Image<std::uint32_t> image(view.width_px, view.height_px, buffers::kNoId);
    buffers::IdParams params;
    params.of = buffers::IdSource::triangle;
    buffers::IdPass pass(params, 0);
    pass.prepare(scene);
    pass.pose(scene);
    if (pass.is_empty()) return image;
    buffers::EachTile sink([&](const raster::Tile& tile) {
        for (int y = 0; y < tile.height_px && !tile.is_empty; ++y) {
            const auto* ids = tile.row<std::uint32_t>(0, y);
            std::copy_n(ids, tile.width_px, image.row(tile.y0_px + y) + tile.x0_px);
        }
    });
    (void)pass.draw({view, core::hardware_threads()}, false, sink);
    return image;
}

/// The materials of all triangles, by global index.
std::vector<std::uint32_t> materials_of(const scene::Scene& scene) {
    std::vector<std::uint32_t> materials;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        if (mesh.materials.empty())
            materials.resize(materials.size() + mesh.triangles.size(), 0);
        else
            materials.insert(materials.end(), mesh.materials.begin(), mesh.materials.end());
    }
    return materials;
}

/// Shares of three corners, (x, y, h) each, in the point of their triangle that a pixel sees: of
/// each the determinant of the pixel with the two others, so that corners behind the eye do no harm
/// (Olano and Greer 1997).
glm::dvec3 seen_shares(const std::array<glm::dvec3, 3>& corners, double x_px, double y_px) {
    const glm::dvec3 pixel(x_px, y_px, 1);
    glm::dvec3 shares(0);
    for (int i = 0; i < 3; ++i) {
        const auto a = static_cast<std::size_t>((i + 1) % 3);
        const auto b = static_cast<std::size_t>((i + 2) % 3);
        shares[i] = glm::dot(pixel, glm::cross(corners[a], corners[b]));
    }
    const double sum = shares.x + shares.y + shares.z;
    return sum != 0 ? shares / sum : glm::dvec3(1.0 / 3);
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kDegPerRad = 180 / std::numbers::pi;

constexpr const char* kConventions =
    "World space is right-handed, y up; a place in it and the origin add up to the place in the "
    "model's file. View space has its origin at the eye, x right, y up, and "
    "looks along -z. Matrices are by rows and take column vectors: p_view = view_from_world "
    "(p_world, 1). clip_from_view is OpenGL's: x, y and z divided by w lie in -1..1. Pixel (0, 0) "
    "is the upper left one and its centre is at (0.5, 0.5): x_px = (x/w + 1) width / 2, y_px = (1 "
    "- y/w) height / 2. Square pixels; the field of view is vertical. A parallel camera sees the "
    "height that it names, in world units. Write an 8-bit image of this "
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
        const glm::dvec3 axis = glm::row(camera.view_from_world, row);
        rows.push_back({axis.x, axis.y, axis.z, moved[row]});
    }
    rows.push_back({0, 0, 0, 1});
    return rows;
}

/// OpenGL's matrix as four rows.
Json clip_matrix(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    if (camera.is_parallel()) {
        const double scale = 2 / camera.height_world;
        const double length = camera.near - camera.far;
        return {{scale * view.height_px / view.width_px, 0, 0, 0},
                {0, scale, 0, 0},
                {0, 0, 2 / length, (camera.far + camera.near) / length},
                {0, 0, 0, 1}};
    }
    const double f = 1 / std::tan(camera.fov_y_rad / 2);
    const double aspect = static_cast<double>(view.width_px) / view.height_px;
    const double depth = camera.near - camera.far;
    return {{f / aspect, 0, 0, 0},
            {0, f, 0, 0},
            {0, 0, (camera.far + camera.near) / depth, 2 * camera.far * camera.near / depth},
            {0, 0, -1, 0}};
}

/// Writes them as multi-layer OpenEXR: `Z`, `N.X N.Y N.Z`, `id.triangle id.object id.patch
/// id.material`. Throws core::Error if the file cannot be written.
void write_buffers_exr(const ViewBuffers& buffers, const std::filesystem::path& path) {
    image_io::ExrFile file;
    file.channels = {{"Z", buffers.w},
                     {"N.X", buffers.normal[0]},
                     {"N.Y", buffers.normal[1]},
                     {"N.Z", buffers.normal[2]},
                     {"id.triangle", buffers.triangle},
                     {"id.object", buffers.object},
                     {"id.patch", buffers.patch},
                     {"id.material", buffers.material}};
    image_io::write_exr(file, path);
}

/// Writes the object ids as an 8-bit RGB PNG: red + 256 green + 65536 blue is the object id + 1, 0
/// for the sky. Throws core::Error if the file cannot be written.
void write_object_ids(const ViewBuffers& buffers, const std::filesystem::path& path) {
    const auto color_of = [](std::uint32_t object) {
        const std::uint32_t code = object + 1;  // kNoId becomes 0
        return image_io::Rgb(code & 0xff, code >> 8 & 0xff, code >> 16 & 0xff);
    };
    image_io::write_png(core::mapped<image_io::Rgb>(buffers.object, color_of), path);
}

}  // namespace

ViewBuffers view_buffers(const scene::Scene& scene, const scene::View& view, double crease_rad) {
    const float sky_w = std::numeric_limits<float>::infinity();
    const auto blank = [&](auto value) {
        return core::Image<decltype(value)>(view.width_px, view.height_px, value);
    };
    ViewBuffers result{triangle_image(scene, view),
                       blank(buffers::kNoId),
                       blank(buffers::kNoId),
                       blank(buffers::kNoId),
                       blank(sky_w),
                       {blank(0.0F), blank(0.0F), blank(0.0F)}};
    const scene::Surface surface = scene::flatten(scene, scene::NormalSource::patch, crease_rad);
    const std::vector<std::uint32_t> patches =
        buffers::surface_ids(scene,
                             buffers::IdSource::object_and_patch,
                             {.crease_rad = crease_rad, .weld_epsilon = kWeldEpsilon});
    const std::vector<std::uint32_t> materials = materials_of(scene);
    const scene::Projection projection(view);
    for (int y = 0; y < view.height_px; ++y) {
        for (int x = 0; x < view.width_px; ++x) {
            const std::uint32_t triangle = result.triangle.at(x, y);
            if (triangle == buffers::kNoId) continue;
            result.object.at(x, y) = surface.object[triangle];
            result.patch.at(x, y) = patches[triangle];
            result.material.at(x, y) = materials[triangle];
            std::array<glm::dvec3, 3> corners;
            glm::dvec3 depths;
            for (int i = 0; i < 3; ++i) {
                const auto corner = surface.triangles[triangle][static_cast<std::size_t>(i)];
                const glm::dvec3& p_world = surface.p_world[corner];
                corners[static_cast<std::size_t>(i)] = projection.to_homogeneous(p_world);
                depths[i] = -projection.to_view(p_world).z;
            }
            const glm::dvec3 shares = seen_shares(corners, x + 0.5, y + 0.5);
            result.w.at(x, y) = static_cast<float>(glm::dot(shares, depths));
            glm::dvec3 n_world(0);
            for (int i = 0; i < 3; ++i) {
                const auto corner = surface.triangles[triangle][static_cast<std::size_t>(i)];
                n_world += shares[i] * glm::dvec3(surface.n_world[corner]);
            }
            const glm::dvec3 n_view = view.camera.view_from_world * n_world;
            const double length = glm::length(n_view);
            for (int i = 0; i < 3 && length > 0; ++i)
                result.normal[static_cast<std::size_t>(i)].at(x, y) =
                    static_cast<float>(n_view[i] / length);
        }
    }
    return result;
}

std::string view_json(const scene::Scene& scene, const scene::View& view, const ViewFiles& files) {
    const scene::Camera& camera = view.camera;
    const auto row = [&](int i) { return glm::row(camera.view_from_world, i); };
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const double ahead =
        std::max(glm::dot(camera.eye_world - bounds.center_world, row(2)), camera.near);
    const Json json = {
        {"format", "inkbench view 1"},
        {"scene", scene.name},
        {"view", camera.name},
        {"width_px", view.width_px},
        {"height_px", view.height_px},
        {"origin", point(scene.origin)},
        {"camera",
         {{"projection", scene::kProjectionNames[camera.is_parallel() ? 1 : 0]},
          {"eye", point(camera.eye_world)},
          {"target", point(camera.eye_world - ahead * row(2))},
          {"up", point(row(1))},
          camera.is_parallel()
              ? Json::object_t::value_type{"height", camera.height_world}
              : Json::object_t::value_type{"fov_y_deg", camera.fov_y_rad * kDegPerRad},
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

ViewFiles write_meshes(const scene::Scene& scene,
                       std::span<const scene::View> views,
                       const fs::path& folder) {
    harness::make_out_folder(folder);
    ViewFiles files{folder / "mesh.obj", folder / "mesh.glb"};
    write_obj(scene, files.obj);
    write_glb(scene, views, files.glb);
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
