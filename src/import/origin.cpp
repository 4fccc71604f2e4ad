#include "import/imported_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "scene/box.h"
#include "scene/precision/rounding.h"

namespace ink::import {
namespace {

/// Along an axis: so far from zero the scene, and so far what lies in a mesh, is moved. A scene
/// that is far out by the one has all of itself beyond the other, so that parts which touch move
/// as one.
constexpr double kFarOriginRadii = 1.5;
constexpr double kFarMeshRadii = 0.5;
/// The same of a mesh that the file has as floats: from there on they lose nothing.
constexpr double kFarFloatRadii = 4;

using scene::Box;

double radius_of(const Box& box) {
    return box.diagonal() * 0.5;
}
/// Whether it holds something and all of it is somewhere.
bool is_finite(const Box& box) {
    return !box.is_empty() && std::isfinite(radius_of(box)) &&
           std::isfinite(glm::length(box.center()));
}

/// Where a mesh stands for each of its uses; what has bones stands by its first.
std::vector<std::vector<glm::dmat4>> places_of(const ImportReply& reply) {
    std::vector<std::vector<glm::dmat4>> places(reply.meshes.size());
    for (const ImportedInstance& instance : reply.instances)
        places[instance.mesh].push_back(instance.world_from_object);
    if (!reply.animation) return places;
    const auto world = scene::world_from_nodes(*reply.animation, std::nullopt);
    for (const scene::Skin& skin : reply.animation->skins) {
        if (skin.bones.empty()) continue;
        const scene::Skin::Bone& bone = skin.bones.front();
        places[skin.mesh] = {world[bone.node] * bone.node_from_mesh};
    }
    return places;
}

Box box_of(const ImportedMesh& mesh) {
    Box box;
    for (const scene::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            box.add(mesh.positions[v]);
    return box;
}

/// The place of `p` in steps of the power of two next above `radius`; 0 along axes on which `far`
/// is not true.
glm::dvec3 in_steps(const glm::dvec3& p, double radius, const glm::bvec3& far) {
    const double step = radius > 0 ? std::exp2(std::ceil(std::log2(radius))) : 1;
    glm::dvec3 result{0};
    for (int axis = 0; axis < 3; ++axis)
        if (far[axis]) result[axis] = std::round(p[axis] / step) * step;
    return result;
}

glm::bvec3 is_beyond(const glm::dvec3& p, double distance) {
    return glm::greaterThan(glm::abs(p), glm::dvec3(distance));
}

/// How far the scene's middle is from zero and how large it is.
Box box_of(const ImportReply& reply, const std::vector<std::vector<glm::dmat4>>& places) {
    Box whole;
    for (std::size_t m = 0; m < reply.meshes.size(); ++m) {
        const Box box = box_of(reply.meshes[m]);
        if (!is_finite(box)) continue;
        for (const glm::dmat4& world_from_mesh : places[m])
            for (int corner = 0; corner < 8; ++corner) {
                const glm::bvec3 is_high{corner & 1, corner & 2, corner & 4};
                whole.add(world_from_mesh * glm::dvec4(glm::mix(box.low, box.high, is_high), 1));
            }
    }
    return whole;
}

/// Moves a mesh that lies far out in its own space by what is returned, so that its world place
/// stays if its transforms take it back.
glm::dvec3 take_out_of_mesh(ImportedMesh& mesh,
                            const glm::dmat4& world_from_mesh,
                            const glm::dvec3& origin_world,
                            double radius_world) {
    // As long as an edge of one is in the world; 0 is no place at all.
    const double stretch = std::cbrt(std::abs(glm::determinant(glm::dmat3(world_from_mesh))));
    const Box box = box_of(mesh);
    if (!(stretch > 0) || !is_finite(box)) return glm::dvec3{0};
    const double radius = radius_world / stretch;
    const glm::dvec3 origin = glm::inverse(world_from_mesh) * glm::dvec4(origin_world, 1);
    const double far_radii = mesh.are_floats ? kFarFloatRadii : kFarMeshRadii;
    const glm::dvec3 taken = in_steps(origin, radius, is_beyond(box.center(), far_radii * radius));
    if (!std::isfinite(glm::length(taken)) || taken == glm::dvec3{0}) return glm::dvec3{0};
    if (mesh.are_floats) {
        for (const glm::dvec3& p : mesh.positions)
            mesh.rounding = std::max(mesh.rounding, scene::half_ulp(glm::vec3(p)));
    }
    for (glm::dvec3& p : mesh.positions)
        p -= taken;
    return taken;
}

void move_roots(const glm::dvec3& by, scene::Animation& animation) {
    for (scene::AnimatedNode& node : animation.nodes) {
        if (node.parent != scene::kNoNode) continue;
        node.parent_from_node = glm::translate(glm::dmat4(1), by) * node.parent_from_node;
        for (scene::VectorKey& key : node.translations)
            key.value += by;
    }
}

/// Lets what hangs on nodes stay in the world although its mesh was moved: it hangs on nodes of its
/// own, which take that back.
void hang_instances(const std::vector<glm::dvec3>& taken, ImportReply& reply) {
    scene::Animation& animation = *reply.animation;
    const std::size_t count = std::min(reply.instances.size(), animation.node_of_instance.size());
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t& node = animation.node_of_instance[i];
        const glm::dvec3& by = taken[reply.instances[i].mesh];
        if (node == scene::kNoNode || by == glm::dvec3{0}) continue;
        scene::AnimatedNode own;
        own.parent = node;
        own.parent_from_node = glm::translate(glm::dmat4(1), by);
        node = static_cast<std::uint32_t>(animation.nodes.size());
        animation.nodes.push_back(std::move(own));
    }
}

/// Gives the animation's parts of the meshes what `take_out_of_mesh` took. What a morph adds is a
/// difference, which stays.
void move_meshes(const std::vector<glm::dvec3>& taken, scene::Animation& animation) {
    for (scene::Skin& skin : animation.skins)
        for (scene::Skin::Bone& bone : skin.bones)
            bone.node_from_mesh = glm::translate(bone.node_from_mesh, taken[skin.mesh]);
    for (std::size_t m = 0; m < std::min(taken.size(), animation.vertex_frames.size()); ++m)
        for (glm::vec3& p : animation.vertex_frames[m].positions)
            p = glm::dvec3(p) - taken[m];
}

}  // namespace

glm::dvec3 take_out_origin(ImportReply& reply) {
    const auto places = places_of(reply);
    const Box whole = box_of(reply, places);
    if (!is_finite(whole)) return glm::dvec3{0};
    const double radius = radius_of(whole);
    const glm::dvec3 origin =
        in_steps(whole.center(), radius, is_beyond(whole.center(), kFarOriginRadii * radius));
    if (origin == glm::dvec3{0}) return origin;

    std::vector<glm::dvec3> taken(reply.meshes.size(), glm::dvec3{0});
    for (std::size_t m = 0; m < reply.meshes.size(); ++m) {
        if (places[m].empty()) continue;
        taken[m] = take_out_of_mesh(reply.meshes[m], places[m].front(), origin, radius);
    }
    const glm::dmat4 back = glm::translate(glm::dmat4(1), -origin);
    std::vector<bool> has_bones(reply.meshes.size(), false);
    if (reply.animation) {
        for (const scene::Skin& skin : reply.animation->skins)
            has_bones[skin.mesh] = true;
        move_roots(-origin, *reply.animation);
        move_meshes(taken, *reply.animation);
        hang_instances(taken, reply);
    }
    for (ImportedInstance& instance : reply.instances) {
        if (has_bones[instance.mesh]) continue;  // its vertices are placed by the bones
        instance.world_from_object =
            back * glm::translate(instance.world_from_object, taken[instance.mesh]);
    }
    for (ImportedCamera& camera : reply.cameras) {
        camera.eye_world -= origin;
        camera.target_world -= origin;
    }
    for (ImportedLight& light : reply.lights)
        light.p_world -= origin;
    return origin;
}

scene::Mesh to_float_mesh(ImportedMesh&& from) {
    scene::Mesh mesh;
    mesh.name = std::move(from.name);
    mesh.positions.assign(from.positions.begin(), from.positions.end());
    mesh.normals = std::move(from.normals);
    mesh.triangles = std::move(from.triangles);
    mesh.rounding = from.rounding;
    mesh.marked_sides = std::move(from.marked_sides);
    const bool is_plain =
        from.parts.empty() || (from.parts.size() == 1 && from.parts.front().material == 0);
    if (is_plain) return mesh;
    mesh.materials.resize(mesh.triangles.size());
    for (std::size_t part = 0; part < from.parts.size(); ++part) {
        const std::size_t end = part + 1 < from.parts.size() ? from.parts[part + 1].first_triangle
                                                             : mesh.triangles.size();
        for (std::size_t t = from.parts[part].first_triangle; t < end; ++t)
            mesh.materials[t] = from.parts[part].material;
    }
    return mesh;
}

}  // namespace ink::import
