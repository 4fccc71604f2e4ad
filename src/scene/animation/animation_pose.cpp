#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "scene/animation.h"

namespace ink::scene {
namespace {

// A time this near to a stored frame, in frames, means that frame.
constexpr double kSameFrame = 1e-9;

/// The vertices of two frames, the second by `share`.
void blend(std::span<const glm::vec3> from,
           std::span<const glm::vec3> to,
           float share,
           std::vector<glm::vec3>& out) {
    out.resize(from.size());
    for (std::size_t v = 0; v < from.size(); ++v)
        out[v] = share == 0 ? from[v] : from[v] * (1 - share) + to[v] * share;
}

/// As `blend`, made unit; where two normals cancel out, the first.
void blend_normals(std::span<const glm::vec3> from,
                   std::span<const glm::vec3> to,
                   float share,
                   std::vector<glm::vec3>& out) {
    blend(from, to, share, out);
    if (share == 0) return;
    for (std::size_t v = 0; v < from.size(); ++v) {
        const float length = std::sqrt(glm::dot(out[v], out[v]));
        out[v] = length > 0 ? out[v] / length : from[v];
    }
}

/// `frame` counts frames from 0, with the way to the next as its fraction. It may lie beyond the
/// last, by more than a whole number holds.
void pose_frames(const VertexFrames& frames, double frame, Mesh& mesh) {
    const std::size_t last = frames.frame_count - 1;
    frame = std::min(frame, static_cast<double>(last));
    const auto first = std::min(static_cast<std::size_t>(frame), last);
    const std::size_t next = std::min(first + 1, last);
    const auto share = static_cast<float>(next == first ? 0 : frame - std::floor(frame));
    const std::size_t vertices = mesh.positions.size();
    const auto of = [&](const std::vector<glm::vec3>& all, std::size_t f) {
        return std::span(all).subspan(f * vertices, vertices);
    };
    blend(of(frames.positions, first), of(frames.positions, next), share, mesh.positions);
    if (frames.normals.empty()) return;
    blend_normals(of(frames.normals, first), of(frames.normals, next), share, mesh.normals);
}

/// A base and the shares of what its targets add to it (glTF 2.0, section 3.7.2.2).
std::vector<glm::dvec3> sum_of(const std::vector<glm::vec3>& base,
                               const std::vector<Morph::Target>& targets,
                               std::vector<glm::vec3> Morph::Target::*part,
                               std::optional<double> time_s) {
    std::vector<glm::dvec3> sum(base.begin(), base.end());
    for (const Morph::Target& target : targets) {
        const double share = target.at(time_s);
        if (share == 0) continue;
        const std::vector<glm::vec3>& more = target.*part;
        for (std::size_t v = 0; v < more.size(); ++v)
            sum[v] += glm::dvec3(more[v]) * share;
    }
    return sum;
}

void pose_morph(const Morph& morph, std::optional<double> time_s, Mesh& mesh) {
    const auto p = sum_of(morph.positions, morph.targets, &Morph::Target::positions, time_s);
    mesh.positions.assign(p.begin(), p.end());
    const auto n = sum_of(morph.normals, morph.targets, &Morph::Target::normals, time_s);
    for (std::size_t v = 0; v < n.size(); ++v) {
        const double length = glm::length(n[v]);
        mesh.normals[v] = length > 0 ? glm::vec3(n[v] / length) : morph.normals[v];
    }
}

/// Linear blend skinning, as glTF 2.0 has it (section 3.7.3): the mesh's own node plays no part.
/// `positions` and `normals` are what is bound; they may be the mesh's own.
void pose_skin(const Skin& skin,
               const std::vector<glm::vec3>& positions,
               const std::vector<glm::vec3>& normals,
               const std::vector<glm::dmat4>& world_from_node,
               Mesh& mesh) {
    std::vector<glm::dmat4> world_from_bound;
    for (const Skin::Bone& bone : skin.bones)
        world_from_bound.push_back(world_from_node[bone.node] * bone.node_from_mesh);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        glm::dmat4 sum(0);
        double total = 0;
        for (std::uint32_t w = skin.first_weight[v]; w < skin.first_weight[v + 1]; ++w) {
            const double weight = skin.weights[w].weight;
            sum += world_from_bound[skin.weights[w].bone] * weight;
            total += weight;
        }
        if (total > 0) sum *= 1 / total;
        if (total == 0) sum = glm::dmat4(1);
        mesh.positions[v] = sum * glm::dvec4(glm::dvec3(positions[v]), 1);
        if (mesh.normals.empty() || normals.empty()) continue;
        // The cofactors turn normals rightly where the bones scale unevenly, inversion included.
        const glm::dmat3 turn(sum);
        const glm::dvec3 n = glm::dmat3(glm::cross(turn[1], turn[2]),
                                        glm::cross(turn[2], turn[0]),
                                        glm::cross(turn[0], turn[1])) *
                             glm::dvec3(normals[v]);
        const double length = glm::length(n);
        mesh.normals[v] = length > 0 ? glm::vec3(n / length) : normals[v];
    }
}

/// Where a camera stands and looks at the moment. One whose node is squeezed flat looks along -z.
void pose_camera(const glm::dmat4& world_from_eye, Camera& camera) {
    const glm::dvec3 eye_world = world_from_eye * glm::dvec4(0, 0, 0, 1);
    glm::dvec3 target_world = world_from_eye * glm::dvec4(0, 0, -1, 1);
    if (glm::length(target_world - eye_world) == 0) {
        // Far out a step of 1 would be lost in rounding.
        target_world.z -= std::max(1.0, glm::length(eye_world));
    }
    const glm::dvec3 up = glm::dmat3(world_from_eye) * glm::dvec3(0, 1, 0);
    const Camera posed = look_at(eye_world, target_world, up, camera.fov_y_rad);
    camera.eye_world = posed.eye_world;
    camera.view_from_world = posed.view_from_world;
    camera.sight_world = posed.sight_world;
}

/// The stored frame at a time, its fraction the way to the next one.
double frame_at(const Animation& animation, double time_s) {
    const double frame = time_s * animation.frames_per_s;
    const double nearest = std::round(frame);
    return std::abs(frame - nearest) < kSameFrame ? nearest : frame;
}

void pose_all(Scene& scene, std::optional<double> time_s, double frame) {
    const Animation& animation = *scene.animation;
    const std::vector<glm::dmat4> world = world_from_nodes(animation, time_s);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::uint32_t node = animation.node_of_instance[i];
        if (node != kNoNode) scene.instances[i].world_from_object = world[node];
    }
    for (std::size_t m = 0; m < animation.vertex_frames.size(); ++m) {
        const VertexFrames& frames = animation.vertex_frames[m];
        if (frames.frame_count > 0) pose_frames(frames, frame, scene.meshes[m]);
    }
    std::vector<bool> is_shaped(scene.meshes.size(), false);
    for (const Morph& morph : animation.morphs) {
        pose_morph(morph, time_s, scene.meshes[morph.mesh]);
        is_shaped[morph.mesh] = true;
    }
    for (const Skin& skin : animation.skins) {
        Mesh& mesh = scene.meshes[skin.mesh];
        const bool is_own = is_shaped[skin.mesh];
        pose_skin(skin,
                  is_own ? mesh.positions : skin.positions,
                  is_own ? mesh.normals : skin.normals,
                  world,
                  mesh);
    }
    for (std::size_t c = 0; c < animation.node_of_camera.size(); ++c) {
        const std::uint32_t node = animation.node_of_camera[c];
        if (node != kNoNode) pose_camera(world[node], scene.cameras[c]);
    }
    for (std::size_t l = 0; l < animation.lights.size(); ++l) {
        const auto& [node, p_node] = animation.lights[l];
        if (node != kNoNode) scene.lights[l].p_world = world[node] * glm::dvec4(p_node, 1);
    }
}

}  // namespace

void pose_scene(Scene& scene, double time_s) {
    if (!scene.animation) return;
    const Animation& animation = *scene.animation;
    time_s = std::clamp(time_s, 0.0, animation.duration_s);
    const double frame = animation.frame_count() > 0 ? frame_at(animation, time_s) : 0;
    pose_all(scene, time_s, frame);
}

void rest_scene(Scene& scene) {
    if (scene.animation) pose_all(scene, std::nullopt, 0);
}

Sphere bounds_of_poses(Scene scene, std::span<const double> times_s) {
    Sphere all = bounding_sphere(scene);
    for (const double time_s : times_s) {
        pose_scene(scene, time_s);
        const Sphere one = bounding_sphere(scene);
        all.radius =
            std::max(all.radius, glm::length(one.center_world - all.center_world) + one.radius);
    }
    return all;
}

}  // namespace ink::scene
