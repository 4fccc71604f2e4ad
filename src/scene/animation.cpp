#include "scene/animation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::scene {
namespace {

// An arc of a quarter turn, halved this often, is so short that its chord is the arc to the last
// bit.
constexpr int kHalvings = 20;

glm::dquat unit(const glm::dquat& q) {
    return q * (1 / std::sqrt(glm::dot(q, q)));
}

/// Where a time lies in a list of keys: at key `first`, or a share of the way on to the next.
struct Place {
    std::size_t first = 0;
    double share = 0;
};

template <class Value>
Place place_in(const std::vector<Key<Value>>& keys, double time_s) {
    const auto after = std::ranges::upper_bound(keys, time_s, {}, &Key<Value>::time_s);
    if (after == keys.begin()) return {};
    const auto first = static_cast<std::size_t>(after - keys.begin()) - 1;
    if (after == keys.end()) return {first, 0};
    const double start_s = keys[first].time_s;
    return {first, (time_s - start_s) / (after->time_s - start_s)};
}

template <class Value>
Value straight(const Value& from, const Value& to, double share) {
    return from * (1 - share) + to * share;
}

glm::dquat straight(const glm::dquat& from, const glm::dquat& to, double share) {
    return slerp(from, to, share);
}

template <class Value>
Value finished(const Value& value, const Value& /*fallback*/) {
    return value;
}

/// A rotation's curve does not stay on the sphere (glTF 2.0, appendix C.4).
glm::dquat finished(const glm::dquat& value, const glm::dquat& fallback) {
    return unit(glm::dot(value, value) > 0 ? value : fallback);
}

/// Hermite's curve from one key to the next (glTF 2.0, appendix C.5), in its notation.
template <class Value>
Value curve(const Key<Value>& from,
            const typename Course<Value>::Tangents& from_tangents,
            const Key<Value>& to,
            const typename Course<Value>::Tangents& to_tangents,
            double t) {
    const double td = to.time_s - from.time_s;
    const double tt = t * t, ttt = tt * t;
    return from.value * (2 * ttt - 3 * tt + 1) + from_tangents.out * (td * (ttt - 2 * tt + t)) +
           to.value * (3 * tt - 2 * ttt) + to_tangents.in * (td * (ttt - tt));
}

template <class Value>
Value value_at(const std::vector<Key<Value>>& keys, const Course<Value>& course, double time_s) {
    const auto [first, share] = place_in(keys, time_s);
    const Key<Value>& from = keys[first];
    const bool is_cubic = course.interpolation == Interpolation::cubic;
    if (share == 0 || course.interpolation == Interpolation::step)
        return is_cubic ? finished(from.value, from.value) : from.value;
    const Key<Value>& to = keys[first + 1];
    if (!is_cubic) return straight(from.value, to.value, share);
    return finished(curve(from, course.tangents[first], to, course.tangents[first + 1], share),
                    from.value);
}

}  // namespace

glm::dmat4 AnimatedNode::at(double time_s) const {
    if (!has_keys()) return parent_from_node;
    const glm::dvec3 scale = value_at(scales, scale_course, time_s);
    glm::dmat4 m = glm::mat4_cast(value_at(rotations, rotation_course, time_s));
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= scale[axis];
    m[3] = glm::dvec4(value_at(translations, translation_course, time_s), 1);
    return m;
}

double Morph::Target::at(std::optional<double> time_s) const {
    return time_s && !weights.empty() ? value_at(weights, course, *time_s) : weight;
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

bool Animation::is_moving(std::uint32_t node) const {
    for (; node != kNoNode; node = nodes[node].parent) {
        const AnimatedNode& at = nodes[node];
        if (std::max({at.translations.size(), at.rotations.size(), at.scales.size()}) > 1)
            return true;
    }
    return false;
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
