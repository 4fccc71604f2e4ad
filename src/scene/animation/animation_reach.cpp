#include "scene/animation/animation_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace ink::scene {
namespace {

/// By how much a transform lengthens a vector, at most: the largest eigenvalue of its square is at
/// most the largest sum along a row of that. Exact where the columns are at right angles, thus for
/// whatever is scaled, then turned.
double growth(const glm::dmat4& m) {
    const glm::dmat3 square = glm::transpose(glm::dmat3(m)) * glm::dmat3(m);
    double most = 0;
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 row = glm::abs(square[column]);  // it is symmetric
        most = std::max(most, row.x + row.y + row.z);
    }
    return std::isnan(most) ? std::numeric_limits<double>::infinity() : std::sqrt(most);
}

double moved_by(const glm::dmat4& m) {
    return glm::length(glm::dvec3(m[3]));
}

double length_of(const glm::dvec3& v) {
    return glm::length(v);
}

double largest_of(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double size_of(double value) {
    return std::abs(value);
}

/// The most that a value can be, by `size`. A cubic course is a mean of two keys and the tangents,
/// each of which counts for 4/27 of the time between the keys at most.
template <class Value, class Size>
double most_of(const std::vector<Key<Value>>& keys, const Course<Value>& course, Size size) {
    double most = 0;
    for (const Key<Value>& key : keys)
        most = std::max(most, size(key.value));
    double bulge = 0;
    for (std::size_t k = 1; k < course.tangents.size(); ++k) {
        const double span_s = keys[k].time_s - keys[k - 1].time_s;
        const double slopes = size(course.tangents[k - 1].out) + size(course.tangents[k].in);
        bulge = std::max(bulge, span_s * slopes * 4 / 27);
    }
    return most + bulge;
}

double radius_of(const std::vector<glm::vec3>& points) {
    double most = 0;
    for (const glm::vec3& p : points)
        most = std::max(most, glm::length(glm::dvec3(p)));
    return most;
}

double radius_of(const Morph& morph) {
    double sum = radius_of(morph.positions);
    for (const Morph::Target& target : morph.targets) {
        const double share =
            std::max(size_of(target.weight), most_of(target.weights, target.course, size_of));
        sum += share * radius_of(target.positions);
    }
    return sum;
}

/// How far the vertices of each mesh can be from its zero before bones take them.
std::vector<double> radii_of(const Scene& scene, const Animation& animation) {
    std::vector<double> radii;
    for (const Mesh& mesh : scene.meshes)
        radii.push_back(radius_of(mesh.positions));
    for (std::size_t m = 0; m < animation.vertex_frames.size(); ++m)
        radii[m] = std::max(radii[m], radius_of(animation.vertex_frames[m].positions));
    for (const Skin& skin : animation.skins)
        radii[skin.mesh] = radius_of(skin.positions);  // the mesh may be posed already
    for (const Morph& morph : animation.morphs)
        radii[morph.mesh] = radius_of(morph);
    return radii;
}

}  // namespace

std::vector<Reach> reaches(const Animation& animation) {
    /// What a node without keys hangs on: the product of all such above it counts as one, so that
    /// what one of them scales another may take back.
    struct Anchor {
        Reach moving{};
        glm::dmat4 moving_from_node{1};
    };
    std::vector<Reach> all;
    std::vector<Anchor> anchors;
    for (const AnimatedNode& node : animation.nodes) {
        const bool is_root = node.parent == kNoNode;
        Anchor anchor = is_root ? Anchor{} : anchors[node.parent];
        if (node.has_keys()) {
            const Reach parent = is_root ? Reach{} : all[node.parent];
            const double moved = most_of(node.translations, node.translation_course, length_of);
            const double grows = most_of(node.scales, node.scale_course, largest_of);
            const glm::dmat4& rest = node.parent_from_node;
            anchor = {.moving = {parent.of(std::max(moved, moved_by(rest))),
                                 parent.grows * std::max(grows, growth(rest))}};
        } else {
            anchor.moving_from_node = anchor.moving_from_node * node.parent_from_node;
        }
        all.push_back({anchor.moving.of(moved_by(anchor.moving_from_node)),
                       anchor.moving.grows * growth(anchor.moving_from_node)});
        anchors.push_back(anchor);
    }
    return all;
}

double farthest_reach(const Scene& scene, const Animation& animation) {
    const std::vector<Reach> reach = reaches(animation);
    const std::vector<double> radii = radii_of(scene, animation);
    double most = 0;
    const auto add = [&](double extent) {
        most =
            std::max(most, std::isnan(extent) ? std::numeric_limits<double>::infinity() : extent);
    };
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::uint32_t node = animation.node_of_instance[i];
        if (node != kNoNode) add(reach[node].of(radii[scene.instances[i].mesh]));
    }
    for (const Morph& morph : animation.morphs)
        add(radii[morph.mesh]);
    for (const std::uint32_t node : animation.node_of_camera)
        if (node != kNoNode) add(reach[node].of(1));  // what it looks at
    for (const LightMotion& light : animation.lights)
        if (light.node != kNoNode) add(reach[light.node].of(glm::length(light.p_node)));
    for (const Skin& skin : animation.skins) {
        for (const Skin::Bone& bone : skin.bones) {
            const Reach bound{moved_by(bone.node_from_mesh), growth(bone.node_from_mesh)};
            add(reach[bone.node].of(bound.of(radii[skin.mesh])));
        }
    }
    return most;
}

}  // namespace ink::scene
