#include "bake/file_normals.h"

#include <array>
#include <glm/trigonometric.hpp>
#include <utility>
#include <vector>

#include "core/numbering.h"
#include "scene/surface.h"

namespace ink::bake {
namespace {

void add_normals_to(scene::Mesh& mesh, double crease_rad, std::vector<glm::vec2>& texcoords) {
    scene::Scene alone;
    alone.meshes = {mesh};
    alone.instances.resize(1);
    const scene::Surface surface = scene::flatten(alone, scene::NormalSource::patch, crease_rad);
    // A vertex of the mesh, and one of the surface there.
    core::Numbering<std::array<std::uint32_t, 2>> known(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            std::uint32_t& corner = mesh.triangles[t][i];
            corner = known.insert({corner, surface.triangles[t][i]}).first;
        }
    std::vector<glm::vec3> positions;
    const std::vector<glm::vec2> before = std::exchange(texcoords, {});
    for (const auto& [vertex, of_surface] : known.keys()) {
        positions.push_back(mesh.positions[vertex]);
        mesh.normals.push_back(surface.n_world[of_surface]);
        if (!before.empty()) texcoords.push_back(before[vertex]);
    }
    mesh.positions = std::move(positions);
}

}  // namespace

void add_normals(scene::Scene& scene,
                 double crease_deg,
                 std::span<std::vector<glm::vec2>> texcoords) {
    std::vector<glm::vec2> none;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        if (scene.meshes[m].normals.empty())
            add_normals_to(
                scene.meshes[m], glm::radians(crease_deg), texcoords.empty() ? none : texcoords[m]);
}

}  // namespace ink::bake
