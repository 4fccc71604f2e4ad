#include "report/live_page.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_access.hpp>
#include <nlohmann/json.hpp>

#include <span>
#include <vector>

#include "bake/coded_mesh.h"
#include "core/base64.h"
#include "core/error.h"
#include "core/escape.h"
#include "core/provenance.h"
#include "core/vocabulary.h"
#include "harness/images/view_images.h"
#include "report/page_template.h"
#include "scene/animation.h"

namespace ink::report {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of the mesh in one element of the page, a multiple of 3; browsers limit a text's length.
constexpr std::size_t kPart_bytes = 24'000'000;

/// When the poses of a moving scene are, that the page mixes: evenly, as often as a page has room
/// for; never where that is too seldom.
std::vector<double> pose_times_s(const scene::Scene& scene, const bake::CodedMesh& mesh) {
    if (scene.animation == nullptr || !(scene.animation->duration_s > 0)) return {};
    constexpr std::size_t kMost_bytes = 20'000'000, kVertex_bytes = 28;
    constexpr std::size_t kLeast = 6, kMost = 64;
    const std::size_t room = kMost_bytes / (kVertex_bytes * mesh.vertex_count());
    if (room < kLeast) return {};
    const double wanted = std::ceil(15 * std::min(scene.animation->duration_s, 60.0)) + 1;
    const std::size_t count =
        std::clamp(static_cast<std::size_t>(wanted), kLeast, std::min(room, kMost));
    std::vector<double> times(count);
    for (std::size_t i = 0; i < count; ++i)
        times[i] =
            scene.animation->duration_s * static_cast<double>(i) / static_cast<double>(count - 1);
    return times;
}

PackedMesh packed(const bake::CodedMesh& mesh,
                  scene::Scene scene,
                  std::span<const double> times_s) {
    std::vector<bake::MovingVertices> poses;
    for (const double time_s : times_s) {
        scene::pose_scene(scene, time_s);
        poses.push_back(bake::posed_vertices(mesh, scene));
    }
    return packed_mesh(mesh, poses);
}

std::string mesh_elements(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += kPart_bytes) {
        const std::size_t count = std::min(kPart_bytes, bytes.size() - at);
        text += "<script type=\"text/plain\" class=\"mesh\">";
        text += core::base64(std::as_bytes(std::span(bytes).subspan(at, count)));
        text += "</script>\n";
    }
    return text;
}

Json point(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

Json view_json(const scene::View& view, const ViewLines& lines) {
    const scene::Camera& camera = view.camera;
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        rows.push_back(point(glm::row(camera.view_from_world, row)));
    Json paths = Json::object();
    for (const draw::ClassPath& path : lines)
        paths[std::string(path.line_class)] = path.path;
    return {{"name", camera.name},
            {"width_px", view.width_px},
            {"height_px", view.height_px},
            {"eye", point(camera.eye_world)},
            {"view_from_world", rows},
            {"fov_y_rad", camera.fov_y_rad},
            {"height_world", camera.height_world},
            {"near", camera.near},
            {"far", camera.far},
            {"lines", paths}};
}

/// What the run's rows of that scene say by view and method: F and soft F, or why there is none.
Json scores_json(const experiment::RunData& run, const harness::SceneViews& scene_views) {
    Json scores = Json::object();
    for (const harness::Row& row : run.tables.rows) {
        if (row.scene != scene_views.scene.name) continue;
        Json& of_view = scores[row.view];
        if (of_view.contains(row.method)) continue;
        Json& score = of_view[row.method] = Json::object();
        if (!row.is_ok()) score["why"] = row.status;
        if (row.f_2px) score["f"] = *row.f_2px;
        if (row.soft) score["soft_f"] = row.soft->f().value_or(0);
    }
    return scores;
}

Json data_json(const harness::SceneViews& scene_views,
               const bake::CodedMesh& mesh,
               std::size_t place_count,
               std::span<const double> times_s,
               const std::optional<experiment::RunData>& run,
               std::span<const ViewLines> lines) {
    const scene::Sphere bounds = scene::bounding_sphere(scene_views.scene);
    Json views = Json::array();
    for (std::size_t i = 0; i < scene_views.views.size(); ++i)
        views.push_back(view_json(scene_views.views[i], lines.empty() ? ViewLines() : lines[i]));
    Json data = {{"version", core::provenance().version},
                 {"scene", scene_views.scene.name},
                 {"origin", point(scene_views.scene.origin)},
                 {"triangle_count", mesh.triangle_count()},
                 {"vertex_count", mesh.vertex_count()},
                 {"added_count", mesh.added_count},
                 {"face_count", mesh.lookup.faces.size()},
                 {"point_count", mesh.lookup.p_world.size()},
                 {"place_count", place_count},
                 {"center", point(bounds.center_world)},
                 {"radius", bounds.radius},
                 {"views", views},
                 {"classes", Json::parse(core::vocabulary().json)["classes"]}};
    if (!times_s.empty()) {
        const scene::Sphere ball = scene::bounds_of_poses(scene_views.scene, times_s);
        data["motion"] = {{"count", times_s.size()},
                          {"duration_s", times_s.back()},
                          {"center", point(ball.center_world)},
                          {"radius", ball.radius}};
    }
    if (run) {
        // "." makes a folder of one that is written with a slash at its end, too.
        const std::filesystem::path folder =
            std::filesystem::absolute(run->folder / ".").lexically_normal();
        data["run"] = folder.parent_path().filename().string();
        data["scores"] = scores_json(*run, scene_views);
    }
    return data;
}

void check_size(const scene::Scene& scene) {
    const std::size_t count = scene::triangle_count(scene);
    if (count == 0)
        throw core::Error(scene.name, "there is nothing to draw: it has no triangle", "a surface");
    if (count > kMostLiveTriangles)
        throw core::Error(scene.name,
                          fmt::format("{} triangles are too many for a page", count),
                          fmt::format("at most {}", kMostLiveTriangles));
}

}  // namespace

std::string live_page(const harness::SceneViews& scene_views,
                      const std::optional<experiment::RunData>& run,
                      std::span<const ViewLines> lines) {
    check_size(scene_views.scene);
    const bake::CodedMesh mesh = bake::coded_mesh(scene_views.scene);
    const std::vector<double> times_s = pose_times_s(scene_views.scene, mesh);
    const PackedMesh packed_arrays = packed(mesh, scene_views.scene, times_s);
    return filled(live_files().index,
                  {{"title", core::escape("Inkbench: " + scene_views.scene.name)},
                   {"style", std::string(live_files().style)},
                   {"scripts", std::string(live_files().scripts)},
                   {"shaders", std::string(live_files().shaders)},
                   {"mesh", mesh_elements(packed_arrays.bytes)},
                   {"data",
                    page_json(data_json(
                        scene_views, mesh, packed_arrays.place_count, times_s, run, lines))}});
}

std::filesystem::path live_page_path(const std::string& scene_name) {
    return std::filesystem::path("live") / (harness::file_name(scene_name) + ".html");
}

}  // namespace ink::report
