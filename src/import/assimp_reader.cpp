// The only file that includes Assimp.

#include "import/assimp_reader.h"

#include <assimp/camera.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "import/camera_3ds.h"

namespace ink::import {
namespace {

struct PlacedNode {
    const aiNode* node;
    glm::dmat4 world_from_node;
    std::uint32_t parent;  ///< in the same list
};

glm::dvec3 to_glm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// The affine part of an Assimp matrix (which is row by row), in double.
glm::dmat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::dmat4(
        m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1));
}

/// All nodes, parents first, in the file's order. No recursion: a hostile tree is deep.
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

/// The triangles of a mesh with its vertices untouched; faces of fewer corners are left out.
ImportedMesh convert_mesh(const aiMesh& from) {
    ImportedMesh mesh;
    mesh.name = from.mName.C_Str();
    mesh.are_floats = true;  // Assimp rounds what the file has
    const auto copy = [&](const aiVector3D* vectors, auto& to) {
        if (vectors == nullptr) return;
        to.reserve(from.mNumVertices);
        for (unsigned v = 0; v < from.mNumVertices; ++v)
            to.emplace_back(vectors[v].x, vectors[v].y, vectors[v].z);
    };
    copy(from.mVertices, mesh.positions);
    copy(from.mNormals, mesh.normals);
    mesh.triangles.reserve(from.mNumFaces);
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3) continue;
        mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    mesh.parts = {{.material = from.mMaterialIndex}};
    return mesh;
}

using NodeNumbers = std::unordered_map<std::string, std::uint32_t>;

/// Nodes by name, the first of each: so Assimp names bones and channels.
NodeNumbers numbers_of(const std::vector<PlacedNode>& nodes) {
    NodeNumbers numbers;
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
        numbers.emplace(nodes[n].node->mName.C_Str(), n);
    return numbers;
}

/// The bones of a mesh; nothing if it has none, or some that are no nodes.
std::optional<scene::Skin> convert_skin(const aiMesh& from,
                                        std::uint32_t number,
                                        const NodeNumbers& numbers) {
    if (from.mNumBones == 0) return std::nullopt;
    scene::Skin skin;
    skin.mesh = number;
    std::vector<std::vector<scene::BoneWeight>> weights(from.mNumVertices);
    for (std::uint32_t b = 0; b < from.mNumBones; ++b) {
        const aiBone& bone = *from.mBones[b];
        const auto node = numbers.find(bone.mName.C_Str());
        if (node == numbers.end()) return std::nullopt;
        skin.bones.push_back({node->second, to_glm(bone.mOffsetMatrix)});
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            if (weight.mVertexId >= weights.size()) return std::nullopt;
            weights[weight.mVertexId].push_back({b, static_cast<float>(weight.mWeight)});
        }
    }
    scene::set_weights(weights, skin);
    return skin;
}

/// Meshes with triangles, and one instance for each use of one by a node. What has bones stands in
/// world space.
void convert_meshes(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    ImportReply& reply,
                    scene::Animation& motion) {
    const NodeNumbers numbers = numbers_of(nodes);
    std::vector<bool> has_bones(scene.mNumMeshes, false);
    constexpr std::uint32_t kDropped = ~0U;
    std::vector<std::uint32_t> index_of(scene.mNumMeshes, kDropped);
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        ImportedMesh mesh = convert_mesh(*scene.mMeshes[m]);
        if (mesh.triangles.empty()) continue;
        index_of[m] = static_cast<std::uint32_t>(reply.meshes.size());
        if (auto skin = convert_skin(*scene.mMeshes[m], index_of[m], numbers)) {
            motion.skins.push_back(std::move(*skin));
            has_bones[m] = true;
        }
        reply.meshes.push_back(std::move(mesh));
    }
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        const PlacedNode& placed = nodes[n];
        for (unsigned i = 0; i < placed.node->mNumMeshes; ++i) {
            const unsigned m = placed.node->mMeshes[i];
            if (m >= scene.mNumMeshes || index_of[m] == kDropped) continue;
            std::string name = placed.node->mName.C_Str();
            if (placed.node->mNumMeshes > 1) name += '/' + reply.meshes[index_of[m]].name;
            const glm::dmat4 place = has_bones[m] ? glm::dmat4(1) : placed.world_from_node;
            reply.instances.push_back({index_of[m], place, std::move(name)});
            motion.node_of_instance.push_back(has_bones[m] ? scene::kNoNode : n);
        }
    }
}

/// Keys in seconds, as they stand.
std::vector<scene::VectorKey> convert_keys(const aiVectorKey* keys, unsigned count, double per_s) {
    std::vector<scene::VectorKey> converted;
    for (unsigned k = 0; k < count; ++k)
        converted.push_back({keys[k].mTime / per_s, to_glm(keys[k].mValue)});
    return converted;
}

glm::dquat to_glm(const aiQuaternion& q) {
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
        node.rotations.push_back({key.mTime / per_s, to_glm(key.mValue)});
    }
    aiVector3D scale;
    aiQuaternion turn;
    aiVector3D place;
    rest.mTransformation.Decompose(scale, turn, place);
    if (node.translations.empty()) node.translations.push_back({0, to_glm(place)});
    if (node.rotations.empty()) node.rotations.push_back({0, to_glm(turn)});
    if (node.scales.empty()) node.scales.push_back({0, to_glm(scale)});
}

/// The tree, and the first animation's keys on it.
void convert_motion(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    scene::Animation& motion) {
    for (const PlacedNode& placed : nodes)
        motion.nodes.push_back({placed.parent, to_glm(placed.node->mTransformation), {}, {}, {}});
    if (scene.mNumAnimations == 0) return;
    const aiAnimation& animation = *scene.mAnimations[0];
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

/// The name of the reader that took the file, such as "glTF2 Importer".
std::string reader_name(const Assimp::Importer& importer) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* about =
        index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
    return about == nullptr ? std::string{} : about->mName;
}

/// Assimp's glTF reader before 5.3 multiplies the angle by the aspect (its issue 4435).
bool multiplies_gltf_angles() {
    return aiGetVersionMajor() < 5 || (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3);
}

/// The camera's vertical angle. Assimp's documentation speaks of half the horizontal angle, its
/// readers (glTF, FBX, Collada; its issue 2256) store all of it. Where a file names no aspect, the
/// glTF reader hands on the vertical angle as it is, which an aspect of 1 undoes; for the others it
/// is a guess.
double vertical_fov_rad(const aiCamera& camera, bool is_gltf) {
    const double aspect = camera.mAspect > 0.05F && camera.mAspect < 20 ? camera.mAspect : 1;
    if (is_gltf && multiplies_gltf_angles()) return camera.mHorizontalFOV / aspect;
    return 2 * std::atan(std::tan(camera.mHorizontalFOV / 2.0) / aspect);
}

ImportedCamera convert_camera(const aiCamera& from,
                              const std::vector<PlacedNode>& nodes,
                              bool is_gltf) {
    const auto home = std::find_if(nodes.begin(), nodes.end(), [&](const PlacedNode& placed) {
        return placed.node->mName == from.mName;
    });
    const bool is_placed = home != nodes.end();
    const auto node = is_placed ? static_cast<std::uint32_t>(home - nodes.begin()) : scene::kNoNode;
    const glm::dmat4 world = is_placed ? home->world_from_node : glm::dmat4{1};
    // A glTF camera sits in its node's origin; Assimp writes the node's translation here once more.
    const glm::dvec3 eye_node = is_gltf ? glm::dvec3{0} : to_glm(from.mPosition);
    const glm::dvec3 view_direction_node = to_glm(from.mLookAt), up_node = to_glm(from.mUp);
    const glm::dvec3 eye = world * glm::dvec4(eye_node, 1);
    return {.name = from.mName.C_Str(),
            .eye_world = eye,
            .target_world = eye + glm::dmat3(world) * view_direction_node,
            .up_world = glm::dmat3(world) * up_node,
            .fov_y_rad = vertical_fov_rad(from, is_gltf),
            .motion = {node, node, eye_node, eye_node + view_direction_node, up_node}};
}

std::vector<ImportedCamera> convert_cameras(const aiScene& scene,
                                            const std::vector<PlacedNode>& nodes,
                                            bool is_gltf) {
    std::vector<ImportedCamera> cameras;
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera& camera = *scene.mCameras[c];
        const bool is_parallel = camera.mOrthographicWidth > 0;  // we have no such camera
        if (!is_parallel) cameras.push_back(convert_camera(camera, nodes, is_gltf));
    }
    return cameras;
}

ImportReply refusal(const Assimp::Importer& importer, const std::filesystem::path& path) {
    ImportReply reply;
    reply.reason = importer.GetErrorString();
    reply.status = ImportStatus::not_readable;
    if (reply.reason.starts_with("No suitable reader found")) {
        const bool is_known = importer.IsExtensionSupported(path.extension().string());
        reply.status = is_known ? ImportStatus::wrong_content : ImportStatus::unknown_format;
    }
    return reply;
}

}  // namespace

ImportReply read_with_assimp(const std::filesystem::path& path,
                             const ImportChoice& /*choice*/,
                             int frame) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_IMPORT_GLOBAL_KEYFRAME, frame);
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    if (scene == nullptr) return refusal(importer, path);
    ImportReply reply;
    // Counted before triangulation: these are what the file's header promises.
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        reply.faces_read += scene->mMeshes[m]->mNumFaces;
        reply.vertices_read += scene->mMeshes[m]->mNumVertices;
    }
    if (reply.faces_read == 0) return reply;  // the validation would only say it less clearly
    // Points and lines stay in and are dropped with the faces that are no triangles: Assimp's own
    // sorting by kind would split meshes and reorder vertices.
    scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure | aiProcess_Triangulate);
    if (scene == nullptr) return refusal(importer, path);
    const std::vector<PlacedNode> nodes = placed_nodes(*scene);
    scene::Animation motion;
    convert_meshes(*scene, nodes, reply, motion);
    convert_motion(*scene, nodes, motion);
    const std::string reader = reader_name(importer);
    const bool is_3ds = reader.starts_with("Discreet 3DS") && !nodes.empty();
    reply.cameras = is_3ds ? read_3ds_cameras(path, motion)
                           : convert_cameras(*scene, nodes, reader.starts_with("glTF2"));
    if (motion.duration_s > 0 || !motion.skins.empty()) reply.animation = std::move(motion);
    return reply;
}

}  // namespace ink::import
