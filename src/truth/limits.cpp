#include "truth/limits.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace ink::truth {
namespace {

// Measured: see bench/README.md, "What is too large".
constexpr std::size_t kTriangleBytes = 150;
constexpr std::size_t kPlaceBytes = 260;

std::size_t vertex_count(const scene::Scene& scene) {
    std::size_t count = 0;
    for (const scene::Instance& instance : scene.instances)
        count += scene.meshes[instance.mesh].positions.size();
    return count;
}

/// Distinct positions, by sorting each instance's own: what instances share counts again.
std::size_t distinct_places(const scene::Scene& scene) {
    std::vector<std::size_t> of_mesh;
    for (const scene::Mesh& mesh : scene.meshes) {
        std::vector<std::array<float, 3>> sorted;
        sorted.reserve(mesh.positions.size());
        for (const glm::vec3& p : mesh.positions)
            sorted.push_back({p.x, p.y, p.z});
        std::ranges::sort(sorted);
        const auto end = std::unique(sorted.begin(), sorted.end());
        of_mesh.push_back(static_cast<std::size_t>(end - sorted.begin()));
    }
    std::size_t count = 0;
    for (const scene::Instance& instance : scene.instances)
        count += of_mesh[instance.mesh];
    return count;
}

}  // namespace

std::size_t memory_estimate(const scene::Scene& scene, std::size_t places) {
    std::size_t bytes = scene::triangle_count(scene) * kTriangleBytes + places * kPlaceBytes;
    for (const scene::Mesh& mesh : scene.meshes) {
        bytes += mesh.positions.size() * sizeof(glm::vec3) +
                 mesh.normals.size() * sizeof(glm::vec3) +
                 mesh.triangles.size() * sizeof(scene::Triangle) +
                 mesh.materials.size() * sizeof(std::uint32_t);
    }
    return bytes;
}

void check_memory(const scene::Scene& scene, const TruthLimits& limits) {
    if (memory_estimate(scene, vertex_count(scene)) <= limits.memory_bytes) return;
    const std::size_t places = distinct_places(scene);
    const std::size_t bytes = memory_estimate(scene, places);
    if (bytes <= limits.memory_bytes) return;
    constexpr std::size_t kMega = 1'000'000;
    throw TooLarge(std::to_string(scene::triangle_count(scene)) + " triangles and " +
                   std::to_string(places) + " vertices are estimated to take " +
                   std::to_string(bytes / kMega) + " MB, more than " +
                   std::to_string(limits.memory_bytes / kMega));
}

}  // namespace ink::truth
