#include "harness/suite/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <set>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "import/rest_alone.h"
#include "scene/animation.h"
#include "scene/views/framing.h"

namespace ink::harness {
namespace {

constexpr int kMaxSide_px = 16384;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 27;
constexpr int kModelViews = 3;
constexpr double kMargin = 0.04;

bool is_catalogue_name(const std::string& what) {
    return core::find_named(catalogue::catalogue(), what) != nullptr;
}

std::vector<scene::Camera> asked_cameras(const ViewRequest& request,
                                         const glm::dvec3& origin,
                                         const scene::Sphere& bounds) {
    std::vector<scene::Camera> cameras;
    for (std::size_t i = 0; i < request.cameras.size(); ++i) {
        cameras.push_back(make_camera(request.cameras[i], origin, bounds));
        cameras.back().name = fmt::format("eye{}", i);
    }
    return cameras;
}

/// A direction of the world with y up, where another axis is up.
glm::dvec3 turned(const glm::dvec3& p, UpAxis up) {
    if (up == UpAxis::x) return {p.y, -p.x, p.z};
    if (up == UpAxis::z) return {p.x, -p.z, p.y};
    return p;
}

/// Cameras under the projections that are asked for.
std::vector<scene::Camera> under_projections(const std::vector<scene::Camera>& cameras,
                                             const ViewRequest& request,
                                             const scene::Sphere& bounds) {
    std::vector<scene::Camera> all;
    for (const scene::ProjectionKind kind : request.projections) {
        for (const scene::Camera& camera : cameras) {
            all.push_back(scene::projected(kind, camera, bounds));
            const bool is_second = request.projections.size() > 1 && all.back().is_parallel();
            if (is_second) all.back().name += ".parallel";
        }
    }
    if (request.projections.empty()) all = cameras;
    for (scene::Camera& camera : all) {
        if (camera.is_parallel() && request.height_world)
            camera.height_world = *request.height_world;
    }
    return all;
}

/// Views from all around, framed as asked.
std::vector<scene::Camera> orbit_of(const scene::Scene& scene, ViewRequest request) {
    const double aspect = static_cast<double>(request.width_px) / request.height_px;
    std::optional<scene::Scene> part;
    if (!request.objects.empty()) part = scene::only_objects(scene, request.objects);
    const scene::Scene& framed = part ? *part : scene;
    const scene::Sphere bounds = scene::bounding_sphere(framed);
    std::vector<scene::Camera> cameras;
    for (scene::NamedDirection direction : request.directions) {
        for (glm::dvec3* p : {&direction.outward_world, &direction.up_world})
            *p = turned(*p, request.up.value_or(UpAxis::y));
        cameras.push_back(scene::camera_round(bounds, direction, aspect));
    }
    if (cameras.empty()) {
        const int count = request.orbit_count.value_or(kModelViews);
        cameras = scene::orbit_cameras(bounds, count, aspect);
    } else if (request.projections.empty()) {
        request.projections = {scene::ProjectionKind::parallel};
    }
    cameras = under_projections(cameras, request, bounds);
    if (part) {
        for (scene::Camera& camera : cameras)
            scene::fit_clip_range(camera, scene::bounding_sphere(scene));
    }
    if (request.fit != Fit::box) return cameras;
    const auto points = scene::placed_points(framed);
    const double fill = 1 - 2 * request.margin.value_or(kMargin);
    for (scene::Camera& camera : cameras)
        camera = scene::framed(camera, points, aspect, fill, scene);
    return cameras;
}

std::vector<scene::Camera> choose_cameras(const scene::Scene& scene,
                                          const ViewRequest& request,
                                          bool is_catalogue_scene) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    if (!request.cameras.empty()) {
        return under_projections(asked_cameras(request, scene.origin, bounds), request, bounds);
    }
    if (request.file_cameras && scene.cameras.empty()) {
        throw core::Error(scene.name,
                          "the file has no camera of its own",
                          "--views N, or --eye X,Y,Z --target X,Y,Z");
    }
    const bool is_framed = request.fit || !request.objects.empty();
    const bool is_round = request.orbit_count || !request.directions.empty() || is_framed;
    if (is_round || !(request.file_cameras || is_catalogue_scene)) return orbit_of(scene, request);
    std::vector<scene::Camera> cameras = scene.cameras;
    const bool is_posed = request.time_s || request.frame;
    for (std::size_t c = 0; c < cameras.size() && is_posed && !is_catalogue_scene; ++c) {
        scene::fit_clip_range(cameras[c], bounds);  // it or the scene has moved
        scene::stand_before(cameras[c], bounds);
    }
    return under_projections(cameras, request, bounds);
}

/// A built-in scene keeps its kind and split.
void say_what_is_listed(const std::vector<ListedModel>& models,
                        const std::string& what,
                        scene::Scene& scene) {
    if (scene.split != scene::Split::real) return;
    const std::string file = std::filesystem::path(what).filename().string();
    const auto found = std::ranges::find(models, file, &ListedModel::file);
    if (found == models.end()) return;
    scene.kind = found->kind;
    scene.split = found->split;
}

void check_moves(const scene::Scene& scene, const char* option) {
    import::check_motion_is_read(scene, option);
    if (scene.animation) return;
    throw core::Error(option,
                      fmt::format("{} does not move", scene.name),
                      "an animated scene: gear, or a model with keyframes, frames or bones");
}

/// Poses the scene at the moment asked for and says so in its name; else it stays at rest.
void pose_as_asked(scene::Scene& scene, const ViewRequest& request) {
    if (request.frame) {
        check_moves(scene, "--frame");
        const std::size_t frames = scene.animation->frame_count();
        if (frames == 0) {
            throw core::Error(
                "--frame", fmt::format("{} stores no frames", scene.name), "--time SECONDS");
        }
        if (*request.frame < 0 || static_cast<std::size_t>(*request.frame) >= frames) {
            throw core::Error("--frame",
                              fmt::format("{} has no frame {}", scene.name, *request.frame),
                              fmt::format("0..{}", frames - 1));
        }
        scene::pose_scene(scene,
                          scene.animation->frame_time_s(static_cast<std::size_t>(*request.frame)));
        scene.name += fmt::format(".frame{}", *request.frame);
    } else if (request.time_s) {
        check_moves(scene, "--time");
        const double duration_s = scene.animation->duration_s;
        if (!(*request.time_s >= 0 && *request.time_s <= duration_s)) {
            throw core::Error(
                "--time",
                fmt::format("{} does not move at {:g} s", scene.name, *request.time_s),
                fmt::format("0..{:g}", duration_s));
        }
        scene::pose_scene(scene, *request.time_s);
        scene.name += fmt::format(".{:g}s", *request.time_s);
    }
}

}  // namespace

double checked_fov_deg(double fov_deg) {
    if (fov_deg >= 1 && fov_deg <= 170) return fov_deg;
    throw core::Error(
        "--fov", fmt::format("the field of view cannot be {:g} degrees", fov_deg), kFovs_deg);
}

double checked_height(double height_world) {
    if (height_world > 0 && std::isfinite(height_world)) return height_world;
    throw core::Error(
        "--parallel", fmt::format("the height seen cannot be {:g}", height_world), kHeights);
}

scene::Camera make_camera(const CameraRequest& request,
                          const glm::dvec3& origin,
                          const scene::Sphere& bounds) {
    const double fov_rad = glm::radians(checked_fov_deg(request.fov_deg));
    const glm::dvec3 target_world =
        request.target_world ? *request.target_world - origin : bounds.center_world;
    const glm::dvec3 eye_world = request.eye_world - origin;
    if (request.height_world) {
        const glm::dvec3 way_world = request.target_world
                                         ? *request.target_world - request.eye_world
                                         : target_world - eye_world;
        return scene::parallel_camera(
            {target_world, way_world, request.up_world, *request.height_world}, bounds);
    }
    scene::Camera camera = scene::look_at(eye_world, target_world, request.up_world, fov_rad);
    scene::fit_clip_range(camera, bounds);
    return camera;
}

UpAxis up_of(const ViewRequest& request, const std::string& what) {
    if (request.up) return *request.up;
    std::string ending = std::filesystem::path(what).extension().string();
    for (char& c : ending)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".stl" ? UpAxis::z : UpAxis::y;
}

void check_size(int width_px, int height_px) {
    const bool is_good = width_px >= 1 && height_px >= 1 && width_px <= kMaxSide_px &&
                         height_px <= kMaxSide_px &&
                         std::int64_t{width_px} * height_px <= kMaxPixels;
    if (!is_good) {
        throw core::Error(
            "--size",
            fmt::format("no image can be {}x{} px", width_px, height_px),
            fmt::format("1..{} px a side, {} Mpx at most", kMaxSide_px, kMaxPixels >> 20));
    }
}

scene::Scene load_scene(const std::string& what,
                        const import::ModelChoice& choice,
                        const import::ImportLimits& limits) {
    if (is_catalogue_name(what)) return catalogue::make_catalogue_scene(what);
    // A bare word that is no file was meant as a scene's name: list those, not file formats.
    const bool looks_like_a_path = what.find_first_of("./") != std::string::npos;
    std::error_code error;
    if (!looks_like_a_path && !std::filesystem::exists(what, error)) {
        return catalogue::make_catalogue_scene(what);
    }
    scene::Scene scene = import::import_scene(what, choice, limits);
    // A file called as a built-in scene is must not be taken for it in the rows.
    if (is_catalogue_name(scene.name)) scene.name = std::filesystem::path(what).filename();
    return scene;
}

SceneViews make_scene_views(scene::Scene scene, const ViewRequest& request) {
    check_size(request.width_px, request.height_px);
    SceneViews scene_views{std::move(scene), {}};
    scene_views.up = request.up.value_or(UpAxis::y);
    scene_views.has_named_views = request.cameras.empty() && !request.directions.empty();
    const bool is_own = is_catalogue_name(scene_views.scene.name);
    pose_as_asked(scene_views.scene, request);
    for (scene::Camera& camera : choose_cameras(scene_views.scene, request, is_own)) {
        scene_views.views.push_back({std::move(camera), request.width_px, request.height_px});
    }
    return scene_views;
}

std::vector<SceneViews> load_scenes(const std::vector<std::string>& names,
                                    const ViewRequest& request) {
    const std::vector<std::string> all =
        names.empty() ? core::names_of(catalogue::catalogue()) : names;
    std::vector<SceneViews> scenes;
    std::set<std::string> taken;
    for (const std::string& name : all) {
        ViewRequest own = request;
        own.up = up_of(request, name);
        SceneViews scene_views =
            make_scene_views(load_scene(name, request.model, request.limits), own);
        say_what_is_listed(request.listed, name, scene_views.scene);
        const std::string base = scene_views.scene.name;
        for (int n = 2; !taken.insert(scene_views.scene.name).second; ++n) {
            scene_views.scene.name = fmt::format("{}.{}", base, n);
        }
        scenes.push_back(std::move(scene_views));
    }
    return scenes;
}

SceneViews load_one_view(const std::string& what,
                         const std::string& view_name,
                         const ViewRequest& request) {
    ViewRequest asked = request;
    asked.up = up_of(request, what);
    scene::Scene scene = load_scene(what, request.model, request.limits);
    const bool has_own =
        is_catalogue_name(scene.name) && core::find_named(scene.cameras, view_name);
    const bool is_usual = request.cameras.empty() && request.directions.empty() &&
                          !request.orbit_count && !request.file_cameras;
    const auto views_by_name = scene::drawing_views();
    const auto* by_name = core::find_named(views_by_name, view_name);
    if (by_name != nullptr && is_usual && !has_own) asked.directions = {*by_name};
    SceneViews scene_views = make_scene_views(std::move(scene), asked);
    std::vector<std::string> names;
    for (const scene::View& view : scene_views.views)
        names.push_back(view.camera.name);
    const auto found = view_name.empty() ? names.begin() : std::ranges::find(names, view_name);
    if (found == names.end()) {
        throw core::Error("--view",
                          fmt::format("{} has no view '{}'", scene_views.scene.name, view_name),
                          core::known_names(names, view_name));
    }
    scene_views.views = {scene_views.views[static_cast<std::size_t>(found - names.begin())]};
    return scene_views;
}

}  // namespace ink::harness
