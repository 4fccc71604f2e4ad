#include "bench/bench_scene.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "import/import.h"

namespace ink::bench {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

std::filesystem::path model_path(const std::string& name) {
    return std::filesystem::path(INK_MODELS_DIR) / name;
}

/// Rings of quads, each cut in two, poles included: 2 * segments * (rings - 1) triangles.
scene::Scene make_sphere(int rings, int segments) {
    scene::Mesh mesh;
    mesh.name = "sphere";
    mesh.positions.push_back({0, 1, 0});
    for (int ring = 1; ring < rings; ++ring) {
        const double down = std::numbers::pi * ring / rings;
        for (int segment = 0; segment < segments; ++segment) {
            const double turn = 2 * std::numbers::pi * segment / segments;
            mesh.positions.push_back(
                {std::sin(down) * std::sin(turn), std::cos(down), std::sin(down) * std::cos(turn)});
        }
    }
    mesh.positions.push_back({0, -1, 0});
    const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    const auto at = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * segments + segment % segments);
    };
    for (int segment = 0; segment < segments; ++segment) {
        mesh.triangles.push_back({0, at(1, segment), at(1, segment + 1)});
        for (int ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back(
                {at(ring, segment), at(ring + 1, segment), at(ring + 1, segment + 1)});
            mesh.triangles.push_back(
                {at(ring, segment), at(ring + 1, segment + 1), at(ring, segment + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, segment), last, at(rings - 1, segment + 1)});
    }
    scene::Scene scene;
    scene.name = mesh.name;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({});
    return scene;
}

scene::Scene make_scene(const std::string& name) {
    if (name == "sphere") return make_sphere(131, 266);
    return import::import_scene(model_path(name + ".ply"));
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
