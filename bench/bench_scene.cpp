#include "bench/bench_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "import/import.h"

namespace ink::bench {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

std::filesystem::path model_path(const char* name) {
    return std::filesystem::path(INK_MODELS_DIR) / name;
}

/// What add_model was given.
std::map<std::string, std::filesystem::path>& model_files() {
    static std::map<std::string, std::filesystem::path> files;
    return files;
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

/// Each triangle as four, through the middles of its edges, which neighbours share.
scene::Mesh subdivide(const scene::Mesh& mesh) {
    scene::Mesh result;
    result.name = mesh.name;
    result.positions = mesh.positions;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(result.positions.size());
        const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), next);
        if (is_new) result.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5F);
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        result.triangles.insert(result.triangles.end(),
                                {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return result;
}

scene::Scene make_scene(const std::string& name) {
    if (const auto found = model_files().find(name); found != model_files().end())
        return import::import_scene(found->second);
    if (name == "sphere") return make_sphere(131, 266);
    if (name == "dragon") return import::import_scene(model_path("dragon.ply"));
    scene::Scene bunny = import::import_scene(model_path("bunny.obj"));
    if (name == "bunny") return bunny;
    for (scene::Mesh& mesh : bunny.meshes)
        mesh = subdivide(subdivide(mesh));
    return bunny;
}

}  // namespace

std::vector<ImageSize> image_sizes() {
    return {{"1080p", kWidth_px, kHeight_px}, {"2160p", 2 * kWidth_px, 2 * kHeight_px}};
}

std::vector<std::string> mesh_names() {
    std::vector<std::string> names = {"sphere"};
    if (std::filesystem::exists(model_path("bunny.obj")))
        names.insert(names.end(), {"bunny", "bunny_x16"});
    if (std::filesystem::exists(model_path("dragon.ply"))) names.push_back("dragon");
    for (const auto& [name, path] : model_files()) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

void add_model(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path))
        throw core::Error("--model", "'" + path.string() + "'", "a model file");
    model_files()[path.stem().string()] = path;
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

std::array<scene::View, 2> bench_views(const scene::Scene& scene, const ImageSize& size) {
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
        view.width_px = size.width_px;
        view.height_px = size.height_px;
    }
    return views;
}

}  // namespace ink::bench
