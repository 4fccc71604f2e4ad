#include "import/assimp/assimp_nodes.h"

#include <assimp/anim.h>
#include <assimp/mesh.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

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

/// Appends a mesh with its vertices untouched, as a part; faces of fewer corners are left out.
void append_mesh(const aiMesh& from, ImportedMesh& to) {
    const auto first_vertex = static_cast<std::uint32_t>(to.positions.size());
    const std::size_t vertices = first_vertex + from.mNumVertices;
    if (from.mVertices != nullptr) {
        to.positions.reserve(vertices);
        for (unsigned v = 0; v < from.mNumVertices; ++v)
            to.positions.push_back(to_glm(from.mVertices[v]));
    }
    if (from.mNormals != nullptr) {
        to.normals.resize(first_vertex, glm::vec3(0));
        to.normals.reserve(vertices);
        for (unsigned v = 0; v < from.mNumVertices; ++v)
            to.normals.push_back(to_glm(from.mNormals[v]));
    } else if (!to.normals.empty()) {
        to.normals.resize(vertices, glm::vec3(0));
    }
    to.parts.push_back({.first_triangle = static_cast<std::uint32_t>(to.triangles.size()),
                        .material = from.mMaterialIndex});
    to.triangles.reserve(to.triangles.size() + from.mNumFaces);
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3) continue;
        const auto corner = [&](int c) { return first_vertex + face.mIndices[c]; };
        to.triangles.push_back({corner(0), corner(1), corner(2)});
    }
}

/// What the vertices of an object follow.
struct Bones {
    std::vector<scene::Skin::Bone> bones;
    std::vector<std::vector<scene::BoneWeight>> weights;  ///< per vertex
};

bool has_bones(const aiMesh& mesh, const NodeNumbers& numbers) {
    const auto is_good = [&](const aiBone* bone) {
        return numbers.count(bone->mName.C_Str()) != 0 &&
               std::all_of(bone->mWeights, bone->mWeights + bone->mNumWeights, [&](auto& weight) {
                   return weight.mVertexId < mesh.mNumVertices;
               });
    };
    return mesh.mNumBones > 0 && std::all_of(mesh.mBones, mesh.mBones + mesh.mNumBones, is_good);
}

/// Appends what a mesh's vertices follow: its bones, or the node that it hangs on.
void append_bones(const aiMesh& from, std::uint32_t node, const NodeNumbers& numbers, Bones& to) {
    const std::size_t first_vertex = to.weights.size();
    to.weights.resize(first_vertex + from.mNumVertices);
    if (!has_bones(from, numbers)) {
        const auto bone = static_cast<std::uint32_t>(to.bones.size());
        to.bones.push_back({node, glm::dmat4(1)});
        for (std::size_t v = first_vertex; v < to.weights.size(); ++v)
            to.weights[v] = {{bone, 1.0F}};
        return;
    }
    for (unsigned b = 0; b < from.mNumBones; ++b) {
        const aiBone& bone = *from.mBones[b];
        const auto number = static_cast<std::uint32_t>(to.bones.size());
        to.bones.push_back({numbers.at(bone.mName.C_Str()), to_glm(bone.mOffsetMatrix)});
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            to.weights[first_vertex + weight.mVertexId].push_back(
                {number, static_cast<float>(weight.mWeight)});
        }
    }
}

/// The meshes of a node that have triangles.
std::vector<const aiMesh*> meshes_of(const aiNode& node, const aiScene& scene) {
    std::vector<const aiMesh*> meshes;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) continue;
        const aiMesh* mesh = scene.mMeshes[node.mMeshes[i]];
        if (has_triangles(*mesh)) meshes.push_back(mesh);
    }
    return meshes;
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
std::vector<PlacedNode> placed_nodes(const aiScene& scene) {
    std::vector<PlacedNode> placed;
    if (scene.mRootNode == nullptr) return placed;
    const glm::dmat4 root = to_glm(scene.mRootNode->mTransformation);
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

bool has_triangles(const aiMesh& mesh) {
    return std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, [](const aiFace& face) {
        return face.mNumIndices == 3;
    });
}

void convert_meshes(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    ImportReply& reply,
                    scene::Animation& motion) {
    const NodeNumbers numbers = numbers_of(nodes);
    std::map<std::vector<const aiMesh*>, std::uint32_t> mesh_of;
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        const std::vector<const aiMesh*> parts = meshes_of(*nodes[n].node, scene);
        if (parts.empty()) continue;
        const bool is_skinned = std::any_of(
            parts.begin(), parts.end(), [&](auto* part) { return has_bones(*part, numbers); });
        auto number = static_cast<std::uint32_t>(reply.meshes.size());
        const auto [known, is_new] = mesh_of.try_emplace(parts, number);
        if (is_new || is_skinned) {
            ImportedMesh& mesh = reply.meshes.emplace_back();
            mesh.name = parts.front()->mName.C_Str();
            mesh.are_floats = true;  // Assimp rounds what the file has
            for (const aiMesh* part : parts)
                append_mesh(*part, mesh);
        } else {
            number = known->second;
        }
        if (is_skinned) {
            Bones bones;
            for (const aiMesh* part : parts)
                append_bones(*part, n, numbers, bones);
            scene::Skin& skin = motion.skins.emplace_back();
            skin.mesh = number;
            skin.bones = std::move(bones.bones);
            scene::set_weights(bones.weights, skin);
        }
        reply.instances.push_back({number,
                                   is_skinned ? glm::dmat4(1) : nodes[n].world_from_node,
                                   nodes[n].node->mName.C_Str()});
        motion.node_of_instance.push_back(is_skinned ? scene::kNoNode : n);
    }
}

}  // namespace ink::import
