#include "import/assimp/assimp_nodes.h"

#include <assimp/anim.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace ink::import {
namespace {

/// Keys in seconds, as they stand.
std::vector<scene::VectorKey> convert_keys(const aiVectorKey* keys, unsigned count, double per_s) {
    std::vector<scene::VectorKey> converted;
    for (unsigned k = 0; k < count; ++k)
        converted.push_back({keys[k].mTime / per_s, to_glm(keys[k].mValue)});
    return converted;
}

glm::dquat to_turn(const aiQuaternion& q) {
    const glm::dquat turn(q.w, q.x, q.y, q.z);
    const double length = glm::length(turn);
    return length > 0 ? turn / length : turn;
}

/// The keys of one node; a kind without any gets the node's own place.
void convert_channel(const aiNodeAnim& from,
                     const aiNode& rest,
                     double per_s,
                     scene::AnimatedNode& node) {
    node.translations = convert_keys(from.mPositionKeys, from.mNumPositionKeys, per_s);
    node.scales = convert_keys(from.mScalingKeys, from.mNumScalingKeys, per_s);
    node.rotations.clear();
    for (unsigned k = 0; k < from.mNumRotationKeys; ++k) {
        const aiQuatKey& key = from.mRotationKeys[k];
        node.rotations.push_back({key.mTime / per_s, to_turn(key.mValue)});
    }
    aiVector3D scale;
    aiQuaternion turn;
    aiVector3D place;
    rest.mTransformation.Decompose(scale, turn, place);
    if (node.translations.empty()) node.translations.push_back({0, to_glm(place)});
    if (node.rotations.empty()) node.rotations.push_back({0, to_turn(turn)});
    if (node.scales.empty()) node.scales.push_back({0, to_glm(scale)});
}

}  // namespace

glm::dvec3 to_glm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

glm::dmat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::dmat4(
        m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1));
}

// No recursion: a hostile tree is deep.
std::vector<PlacedNode> placed_nodes(const aiScene& scene, const glm::dmat4& world_from_file) {
    std::vector<PlacedNode> placed;
    if (scene.mRootNode == nullptr) return placed;
    const glm::dmat4 root = world_from_file * to_glm(scene.mRootNode->mTransformation);
    std::vector<PlacedNode> open{{scene.mRootNode, root, scene::kNoNode}};
    while (!open.empty()) {
        const PlacedNode current = open.back();
        open.pop_back();
        const auto parent = static_cast<std::uint32_t>(placed.size());
        placed.push_back(current);
        for (unsigned c = current.node->mNumChildren; c-- > 0;) {
            const aiNode* child = current.node->mChildren[c];
            open.push_back(
                {child, current.world_from_node * to_glm(child->mTransformation), parent});
        }
    }
    return placed;
}

NodeNumbers numbers_of(const std::vector<PlacedNode>& nodes) {
    NodeNumbers numbers;
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
        numbers.emplace(nodes[n].node->mName.C_Str(), n);
    return numbers;
}

void convert_motion(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    std::size_t chosen,
                    scene::Animation& motion) {
    for (const PlacedNode& placed : nodes) {
        motion.nodes.push_back({placed.parent,
                                placed.parent == scene::kNoNode
                                    ? placed.world_from_node
                                    : to_glm(placed.node->mTransformation),
                                {},
                                {},
                                {}});
    }
    if (chosen >= scene.mNumAnimations) return;
    const aiAnimation& animation = *scene.mAnimations[chosen];
    // 3DS files name no rate and mean 30.
    const double per_s = animation.mTicksPerSecond != 0 ? animation.mTicksPerSecond : 30;
    const NodeNumbers numbers = numbers_of(nodes);
    bool is_moving = false;
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        const aiNodeAnim& channel = *animation.mChannels[c];
        const auto number = numbers.find(channel.mNodeName.C_Str());
        if (number == numbers.end()) continue;
        scene::AnimatedNode& node = motion.nodes[number->second];
        convert_channel(channel, *nodes[number->second].node, per_s, node);
        const std::size_t keys =
            std::max({node.translations.size(), node.rotations.size(), node.scales.size()});
        is_moving = is_moving || keys > 1;
    }
    if (is_moving) motion.duration_s = animation.mDuration / per_s;
}

}  // namespace ink::import
