#include "scene/animation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

namespace ink::scene {
namespace {

// An arc of a quarter turn, halved this often, is so short that its chord is the arc to the last
// bit.
constexpr int kHalvings = 20;
// A time this near to a stored frame, in frames, means that frame.
constexpr double kSameFrame = 1e-9;

glm::dquat unit(const glm::dquat& q) {
    return q * (1 / std::sqrt(glm::dot(q, q)));
}

/// Where a time lies in a list of keys: at key `first`, or a share of the way on to the next.
struct Place {
    std::size_t first = 0;
    double share = 0;
};

template <class Key>
Place place_in(const std::vector<Key>& keys, double time_s) {
    const auto after = std::upper_bound(
        keys.begin(), keys.end(), time_s, [](double t, const Key& key) { return t < key.time_s; });
    if (after == keys.begin()) return {};
    const auto first = static_cast<std::size_t>(after - keys.begin()) - 1;
    if (after == keys.end()) return {first, 0};
    const double start_s = keys[first].time_s;
    return {first, (time_s - start_s) / (after->time_s - start_s)};
}

glm::dvec3 value_at(const std::vector<VectorKey>& keys, double time_s) {
    const Place place = place_in(keys, time_s);
    const glm::dvec3& from = keys[place.first].value;
    if (place.share == 0) return from;
    return from * (1 - place.share) + keys[place.first + 1].value * place.share;
}

glm::dquat value_at(const std::vector<RotationKey>& keys, double time_s) {
    const Place place = place_in(keys, time_s);
    const glm::dquat& from = keys[place.first].value;
    if (place.share == 0) return from;
    return slerp(from, keys[place.first + 1].value, place.share);
}

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

/// `frame` counts frames from 0, with the way to the next as its fraction.
void pose_frames(const VertexFrames& frames, double frame, Mesh& mesh) {
    const std::size_t last = frames.frame_count - 1;
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

/// Linear blend skinning, as glTF 2.0 has it (section 3.7.3): the mesh's own node plays no part.
void pose_skin(const Skin& skin, const std::vector<glm::dmat4>& world_from_node, Mesh& mesh) {
    std::vector<glm::dmat4> world_from_bound;
    for (const Skin::Bone& bone : skin.bones)
        world_from_bound.push_back(world_from_node[bone.node] * bone.node_from_mesh);
    for (std::size_t v = 0; v < skin.positions.size(); ++v) {
        glm::dmat4 sum(0);
        double total = 0;
        for (std::uint32_t w = skin.first_weight[v]; w < skin.first_weight[v + 1]; ++w) {
            const double weight = skin.weights[w].weight;
            sum += world_from_bound[skin.weights[w].bone] * weight;
            total += weight;
        }
        if (total > 0) sum *= 1 / total;
        if (total == 0) sum = glm::dmat4(1);
        mesh.positions[v] = sum * glm::dvec4(glm::dvec3(skin.positions[v]), 1);
        if (mesh.normals.empty() || skin.normals.empty()) continue;
        // The cofactors turn normals rightly where the bones scale unevenly, inversion included.
        const glm::dmat3 turn(sum);
        const glm::dvec3 n = glm::dmat3(glm::cross(turn[1], turn[2]),
                                        glm::cross(turn[2], turn[0]),
                                        glm::cross(turn[0], turn[1])) *
                             glm::dvec3(skin.normals[v]);
        const double length = glm::length(n);
        mesh.normals[v] = length > 0 ? glm::vec3(n / length) : skin.normals[v];
    }
}

/// The stored frame at a time, its fraction the way to the next one.
double frame_at(const Animation& animation, double time_s, Between between) {
    const double frame = time_s * animation.frames_per_s;
    const double nearest = std::round(frame);
    if (std::abs(frame - nearest) < kSameFrame) return nearest;
    return between == Between::whole ? std::floor(frame) : frame;
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
    for (const Skin& skin : animation.skins)
        pose_skin(skin, world, scene.meshes[skin.mesh]);
}

}  // namespace

glm::dmat4 AnimatedNode::at(double time_s) const {
    if (!has_keys()) return parent_from_node;
    const glm::dvec3 scale = value_at(scales, time_s);
    glm::dmat4 m = glm::mat4_cast(value_at(rotations, time_s));
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= scale[axis];
    m[3] = glm::dvec4(value_at(translations, time_s), 1);
    return m;
}

std::vector<glm::dmat4> world_from_nodes(const Animation& animation, std::optional<double> time_s) {
    std::vector<glm::dmat4> world;
    world.reserve(animation.nodes.size());
    for (const AnimatedNode& node : animation.nodes) {
        const glm::dmat4 local = time_s ? node.at(*time_s) : node.parent_from_node;
        world.push_back(node.parent == kNoNode ? local : world[node.parent] * local);
    }
    return world;
}

void set_weights(const std::vector<std::vector<BoneWeight>>& of_vertex, Skin& skin) {
    skin.weights.clear();
    skin.first_weight = {0};
    for (const std::vector<BoneWeight>& weights : of_vertex) {
        skin.weights.insert(skin.weights.end(), weights.begin(), weights.end());
        skin.first_weight.push_back(static_cast<std::uint32_t>(skin.weights.size()));
    }
}

std::size_t Animation::frame_count() const {
    std::size_t most = 0;
    for (const VertexFrames& frames : vertex_frames)
        most = std::max(most, frames.frame_count);
    return most;
}

double Animation::frame_time_s(std::size_t frame) const {
    assert(frame < frame_count());
    return static_cast<double>(frame) / frames_per_s;
}

void pose_scene(Scene& scene, double time_s, Between between) {
    if (!scene.animation) return;
    const Animation& animation = *scene.animation;
    time_s = std::clamp(time_s, 0.0, animation.duration_s);
    const bool has_frames = animation.frame_count() > 0;
    const double frame = has_frames ? frame_at(animation, time_s, between) : 0;
    if (has_frames && between == Between::whole) time_s = frame / animation.frames_per_s;
    pose_all(scene, time_s, frame);
}

void rest_scene(Scene& scene) {
    if (scene.animation) pose_all(scene, std::nullopt, 0);
}

glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double share) {
    glm::dquat low = from;
    glm::dquat high = glm::dot(from, to) < 0 ? -to : to;
    for (int i = 0; i < kHalvings; ++i) {
        const glm::dquat middle = unit(low + high);  // at most a quarter turn apart: never 0
        share *= 2;
        if (share >= 1) {
            low = middle;
            share -= 1;
        } else {
            high = middle;
        }
    }
    return unit(low * (1 - share) + high * share);
}

}  // namespace ink::scene
