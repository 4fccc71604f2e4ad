#include "bake/baked_primitives.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace ink::bake {
namespace {

/// A part of an instance's mesh: triangles first..last of that mesh, which begin in the scene at
/// `first_triangle`.
struct ScenePart {
    const scene::Mesh& mesh;
    const import::MeshPart& part;
    std::size_t first_triangle = 0;
    std::size_t end = 0;
};

bool has_same_triangles(const std::vector<scene::Triangle>& triangles, const ScenePart& part) {
    const std::size_t first = part.part.first_triangle;
    if (triangles.size() != part.end - first) return false;
    const std::uint32_t vertex = part.part.first_vertex;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        if (part.mesh.triangles[first + t] != scene::Triangle{a + vertex, b + vertex, c + vertex})
            return false;
    }
    return true;
}

BakedPrimitive baked(GltfEdit& edit, std::size_t mesh, const ScenePart& part) {
    const auto primitives = edit.document().meshes[mesh].list("primitives", "primitive");
    const std::size_t number = part.part.primitive;
    const auto changed = [&] {
        throw core::Error(edit.document().meshes[mesh].place(),
                          "the file was changed while it was read");
    };
    if (number >= primitives.size()) changed();
    BakedPrimitive primitive{
        .mesh = mesh,
        .number = number,
        .first_triangle = part.first_triangle,
        .source = {edit.document(), edit.buffers(), edit.accessors(), primitives[number]},
        .triangles = {},
        .turns = {}};
    primitive.triangles = primitive.source.triangles();
    primitive.turns.resize(primitive.triangles.size(), 0);
    if (!has_same_triangles(primitive.triangles, part)) changed();
    return primitive;
}

bool has_triangles(const import::JsonObject& mesh) {
    const auto primitives = mesh.list("primitives", "primitive");
    return std::any_of(primitives.begin(), primitives.end(), import::is_of_triangles);
}

}  // namespace

std::string BakedPrimitive::place() const {
    return fmt::format("mesh {}, primitive {}", mesh, number);
}

Json& BakedPrimitive::json(GltfEdit& edit) const {
    return edit.json()["meshes"][mesh]["primitives"][number];
}

BakedPrimitives find_primitives(GltfEdit& edit, const import::ImportedModel& model) {
    const scene::Scene& scene = model.scene;
    const import::FilePlaces& places = model.places;
    const auto& document = edit.document();
    BakedPrimitives found;
    std::vector<int> uses(document.meshes.size(), 0);
    std::size_t first_triangle = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Mesh& of_scene = scene.meshes[scene.instances[i].mesh];
        const auto& node = document.nodes.at(places.node_of_instance[i]);
        const std::size_t mesh = node.index("mesh", document.meshes.size());
        const auto& parts = places.parts_of_mesh[scene.instances[i].mesh];
        for (std::size_t p = 0; p < parts.size() && uses[mesh] == 0; ++p) {
            const std::size_t end =
                p + 1 < parts.size() ? parts[p + 1].first_triangle : of_scene.triangles.size();
            found.list.push_back(baked(
                edit, mesh, {of_scene, parts[p], first_triangle + parts[p].first_triangle, end}));
        }
        ++uses[mesh];
        first_triangle += of_scene.triangles.size();
    }
    for (std::size_t m = 0; m < uses.size(); ++m) {
        found.repeated_meshes += uses[m] > 1;
        found.absent_meshes += uses[m] == 0 && has_triangles(document.meshes[m]);
    }
    return found;
}

}  // namespace ink::bake
