#include "scene/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "scene/animation.h"

namespace ink::scene {
namespace {

constexpr std::uint32_t kUnused = ~0U;

/// Some triangles of a mesh with all of its vertices, so that what moves these still fits.
Mesh part_of(const Mesh& mesh, const std::vector<std::size_t>& triangles) {
    Mesh part = mesh;
    part.triangles.clear();
    part.marked_sides.clear();
    for (const std::size_t t : triangles) {
        part.triangles.push_back(mesh.triangles[t]);
        if (!mesh.marked_sides.empty()) part.marked_sides.push_back(mesh.marked_sides[t]);
    }
    part.materials.assign(triangles.size(), mesh.materials[triangles.front()]);
    return part;
}

/// Takes out the vertices that no triangle uses.
void drop_unused(Mesh& mesh) {
    std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
    const Mesh from = std::move(mesh);
    mesh = {from.name, {}, {}, from.triangles, from.materials, from.rounding, from.marked_sides};
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) {
            if (number[v] == kUnused) {
                number[v] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(from.positions[v]);
                if (!from.normals.empty()) mesh.normals.push_back(from.normals[v]);
            }
            v = number[v];
        }
}

/// The triangles of each material of a mesh.
std::map<std::uint32_t, std::vector<std::size_t>> by_material(const Mesh& mesh) {
    std::map<std::uint32_t, std::vector<std::size_t>> parts;
    for (std::size_t t = 0; t < mesh.materials.size(); ++t)
        parts[mesh.materials[t]].push_back(t);
    return parts;
}

/// Copies what of a list belongs to the mesh numbered `mesh` for the one numbered `copy`.
template <class Motion>
void copy_for(std::vector<Motion>& all, std::uint32_t mesh, std::uint32_t copy) {
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        if (all[i].mesh != mesh) continue;
        Motion motion = all[i];
        motion.mesh = copy;
        all.push_back(std::move(motion));
    }
}

/// Gives the mesh numbered `copy` what moves that numbered `mesh`.
void copy_motion(Animation& animation, std::uint32_t mesh, std::uint32_t copy) {
    if (!animation.vertex_frames.empty()) {
        animation.vertex_frames.resize(copy + 1);
        animation.vertex_frames[copy] = animation.vertex_frames[mesh];
    }
    copy_for(animation.morphs, mesh, copy);
    copy_for(animation.skins, mesh, copy);
}

bool moves_vertices(const Animation& animation, std::uint32_t mesh) {
    const auto is_of_mesh = [&](const auto& motion) { return motion.mesh == mesh; };
    return std::ranges::any_of(animation.skins, is_of_mesh) ||
           std::ranges::any_of(animation.morphs, is_of_mesh) ||
           (mesh < animation.vertex_frames.size() && animation.vertex_frames[mesh].frame_count > 0);
}

}  // namespace

void split_materials(Scene& scene) {
    std::shared_ptr<Animation> animation =
        scene.animation ? std::make_shared<Animation>(*scene.animation) : nullptr;
    // The meshes that each mesh becomes: itself alone, or one for each material.
    std::vector<std::vector<std::uint32_t>> parts_of(scene.meshes.size());
    for (std::uint32_t m = 0; m < parts_of.size(); ++m) {
        parts_of[m] = {m};
        const auto parts = by_material(scene.meshes[m]);
        if (parts.size() < 2) continue;
        const bool is_moved = animation && moves_vertices(*animation, m);
        const Mesh whole = scene.meshes[m];
        parts_of[m].clear();
        for (const auto& [material, triangles] : parts) {
            const bool is_first = parts_of[m].empty();
            const auto number = is_first ? m : static_cast<std::uint32_t>(scene.meshes.size());
            Mesh part = part_of(whole, triangles);
            if (!is_moved) drop_unused(part);
            if (is_first) {
                scene.meshes[m] = std::move(part);
            } else {
                scene.meshes.push_back(std::move(part));
                if (animation) copy_motion(*animation, m, number);
            }
            parts_of[m].push_back(number);
        }
    }
    const std::vector<Instance> instances = std::move(scene.instances);
    std::vector<std::uint32_t> nodes;
    scene.instances.clear();
    for (std::size_t i = 0; i < instances.size(); ++i) {
        for (const std::uint32_t part : parts_of[instances[i].mesh]) {
            Instance object = instances[i];
            object.mesh = part;
            if (parts_of[instances[i].mesh].size() > 1)
                object.name += fmt::format("/material {}", scene.meshes[part].materials.front());
            scene.instances.push_back(std::move(object));
            if (animation) nodes.push_back(animation->node_of_instance[i]);
        }
    }
    if (!animation) return;
    animation->node_of_instance = std::move(nodes);
    scene.animation = std::move(animation);
}

}  // namespace ink::scene
