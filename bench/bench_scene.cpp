#include "bench/bench_scene.h"

#include <cmath>
#include <map>
#include <numbers>

#include "catalogue/shapes.h"
#include "import/import.h"

namespace ink::bench {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

std::filesystem::path model_path(const std::string& name) {
    return std::filesystem::path(INK_MODELS_DIR) / name;
}

scene::Scene make_scene(const std::string& name) {
    if (name != "sphere") return import::import_scene(model_path(name + ".ply"));
    scene::Scene scene;
    scene.name = name;
    scene.meshes.push_back(catalogue::make_sphere(1, 266, 131));
    scene.instances.push_back({});
    return scene;
}

}  // namespace

std::vector<std::string> mesh_names() {
    std::vector<std::string> names = {"sphere"};
    for (const char* name : {"dragon_coarse", "dragon"})
        if (std::filesystem::exists(model_path(std::string(name) + ".ply"))) names.push_back(name);
    return names;
}

const scene::Scene& bench_scene(const std::string& name) {
    static std::map<std::string, scene::Scene> scenes;
    scene::Scene& kept = scenes[name];
    if (kept.meshes.empty()) kept = make_scene(name);
    return kept;
}

const scene::Surface& bench_surface(const std::string& name) {
    static std::map<std::string, scene::Surface> surfaces;
    scene::Surface& kept = surfaces[name];
    if (kept.triangles.empty())
        kept = scene::flatten(bench_scene(name), scene::NormalSource::patch, 40 * kRadPerDeg);
    return kept;
}

std::array<scene::View, 2> bench_views(const scene::Scene& scene) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const double fov_rad = 40 * kRadPerDeg;
    const double distance = bounds.radius / std::sin(fov_rad / 2);
    std::array<scene::View, 2> views;
    for (int i = 0; i < 2; ++i) {
        const double turn = (30 + i) * kRadPerDeg;
        const glm::dvec3 away{std::sin(turn) * 0.95, 0.3, std::cos(turn) * 0.95};
        auto& view = views[static_cast<std::size_t>(i)];
        view.camera = scene::look_at(
            bounds.center_world + distance * away, bounds.center_world, {0, 1, 0}, fov_rad);
        scene::fit_clip_range(view.camera, bounds);
        view.width_px = kWidth_px;
        view.height_px = kHeight_px;
    }
    return views;
}

}  // namespace ink::bench
