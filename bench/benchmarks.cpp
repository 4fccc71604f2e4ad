#include "bench/benchmarks.h"

#include <sched.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "catalogue/shapes.h"
#include "core/parallel.h"
#include "import/import.h"

namespace ink::bench {
namespace {

constexpr const char* kName = "ink_bench";

std::vector<int> allowed_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cores;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set)) cores.push_back(core);
    }
    return cores;
}

/// Names a physical core; two hardware threads of one have the same. Empty if the system is silent.
std::string siblings_of(int core) {
    std::ifstream file("/sys/devices/system/cpu/cpu" + std::to_string(core) +
                       "/topology/thread_siblings_list");
    std::string line;
    std::getline(file, line);
    return line;
}

/// The last core that is not `first`, preferably one that shares nothing with it; -1 if none.
int second_core(const std::vector<int>& cores, int first) {
    int sibling = -1;
    for (auto core = cores.rbegin(); core != cores.rend(); ++core) {
        if (*core == first) continue;
        const std::string name = siblings_of(*core);
        if (name.empty() || name != siblings_of(first)) return *core;
        if (sibling < 0) sibling = *core;
    }
    return sibling;
}

bool pin(pid_t thread, int core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    return sched_setaffinity(thread, sizeof set, &set) == 0;
}

/// Has oneTBB count the cores and make its worker before either is pinned: two bodies that wait for
/// each other cannot be run by one thread. They wait a second at most.
void wake_worker() {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(1);
    std::atomic<int> arrived{0};
    core::parallel_for(2, 2, [&](std::size_t) {
        ++arrived;
        while (arrived < 2 && Clock::now() < end) {
        }
    });
}

bool pin_others(int core) {
    bool is_done = true;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
        const auto thread = static_cast<pid_t>(std::stol(entry.path().filename().string()));
        if (thread != getpid()) is_done = pin(thread, core) && is_done;
    }
    return is_done;
}

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

void pin_to_cores() {
    const std::vector<int> cores = allowed_cores();
    const int first = cores.empty() ? -1 : cores.back();
    const int second = second_core(cores, first);
    if (second < 0) {
        std::fprintf(stderr, "%s: one core only: threads:2 will show no gain\n", kName);
    } else {
        wake_worker();
        if (siblings_of(first) == siblings_of(second) && !siblings_of(first).empty())
            std::fprintf(stderr, "%s: threads:2 shares one physical core\n", kName);
        if (!pin_others(second))
            std::fprintf(stderr, "%s: a worker is not pinned: %s\n", kName, std::strerror(errno));
    }
    if (first < 0 || !pin(0, first))
        std::fprintf(stderr, "%s: not pinned to a core: %s\n", kName, std::strerror(errno));
}

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
