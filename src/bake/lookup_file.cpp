#include "bake/bake.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/trigonometric.hpp>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/numbering.h"
#include "methods/mesh_lookup/lookup_table.h"
#include "scene/surface.h"

namespace ink::bake {
namespace {

/// What one draw call draws.
struct DrawnPart {
    std::uint32_t node = 0;
    std::uint32_t primitive = 0;
    std::size_t first_corner = 0;  ///< 3 times the global index of its first triangle
    const scene::Triangle* triangles = nullptr;
    std::uint32_t first_vertex = 0;  ///< of the scene's mesh
};

/// The parts of a model by their first corner.
std::vector<DrawnPart> drawn_parts(const import::ImportedModel& model) {
    const auto& nodes = model.places.node_of_instance;
    if (std::ranges::adjacent_find(nodes) != nodes.end())
        throw core::Error("EXT_mesh_gpu_instancing",
                          "copies of a mesh in one node have no place in tables",
                          "a node for each");
    std::vector<DrawnPart> parts;
    std::size_t first_triangle = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::uint32_t number = model.scene.instances[i].mesh;
        const scene::Mesh& mesh = model.scene.meshes[number];
        for (const import::MeshPart& part : model.places.parts_of_mesh[number])
            parts.push_back({.node = nodes[i],
                             .primitive = static_cast<std::uint32_t>(part.primitive),
                             .first_corner = 3 * (first_triangle + part.first_triangle),
                             .triangles = mesh.triangles.data() + part.first_triangle,
                             .first_vertex = static_cast<std::uint32_t>(part.first_vertex)});
        first_triangle += mesh.triangles.size();
    }
    return parts;
}

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

std::string lookup_file(const import::ImportedModel& model, double crease_deg) {
    const std::vector<DrawnPart> parts = drawn_parts(model);
    const methods::LookupTable table = methods::lookup_table(model.scene, crease_deg);
    std::vector<std::uint32_t> words;
    for (const std::size_t count : {table.faces.size(), parts.size(), table.corners.size()})
        words.push_back(static_cast<std::uint32_t>(count));
    for (const methods::LookupTable::Face& face : table.faces) {
        words.insert(words.end(), face.corners.begin(), face.corners.end());
        words.push_back(face.patch);
        words.insert(words.end(), face.twins.begin(), face.twins.end());
        words.push_back(face.rest);
    }
    for (const DrawnPart& part : parts)
        words.insert(words.end(), {part.node, part.primitive});
    for (const std::uint32_t corner : table.corners) {
        const auto next =
            std::ranges::upper_bound(parts, std::size_t{corner}, {}, &DrawnPart::first_corner);
        const DrawnPart& part = *(next - 1);
        const std::size_t of_part = corner - part.first_corner;
        words.push_back(static_cast<std::uint32_t>(&part - parts.data()));
        words.push_back(part.triangles[of_part / 3][of_part % 3] - part.first_vertex);
    }
    std::string bytes(words.size() * sizeof(std::uint32_t), '\0');
    std::memcpy(bytes.data(), words.data(), bytes.size());
    return bytes;
}

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
