#include "import/animation_stream.h"

namespace ink::import {
namespace {

static_assert(sizeof(scene::VectorKey) == 32 && sizeof(scene::RotationKey) == 40 &&
                  sizeof(scene::BoneWeight) == 8,
              "arrays travel as they lie in memory, without gaps");

// The least that each kind takes in the stream, so that a claimed count can be judged.
constexpr std::size_t kLeastNodeBytes = 156;
constexpr std::size_t kLeastFramesBytes = 24;
constexpr std::size_t kLeastSkinBytes = 44;
constexpr std::size_t kBoneBytes = 132;

template <class T>
void write_list(const std::vector<T>& list, ByteWriter& writer) {
    writer.items(std::span<const T>(list));
}

void write_node(const scene::AnimatedNode& node, ByteWriter& writer) {
    writer.value(node.parent);
    writer.value(node.parent_from_node);
    write_list(node.translations, writer);
    write_list(node.rotations, writer);
    write_list(node.scales, writer);
}

scene::AnimatedNode read_node(ByteReader& reader) {
    scene::AnimatedNode node;
    node.parent = reader.value<std::uint32_t>();
    node.parent_from_node = reader.value<glm::dmat4>();
    reader.items(node.translations);
    reader.items(node.rotations);
    reader.items(node.scales);
    return node;
}

void write_frames(const scene::VertexFrames& frames, ByteWriter& writer) {
    writer.value<std::uint64_t>(frames.frame_count);
    write_list(frames.positions, writer);
    write_list(frames.normals, writer);
}

scene::VertexFrames read_frames(ByteReader& reader) {
    scene::VertexFrames frames;
    frames.frame_count = static_cast<std::size_t>(reader.value<std::uint64_t>());
    reader.items(frames.positions);
    reader.items(frames.normals);
    return frames;
}

void write_skin(const scene::Skin& skin, ByteWriter& writer) {
    writer.value(skin.mesh);
    write_list(skin.positions, writer);
    write_list(skin.normals, writer);
    writer.value<std::uint64_t>(skin.bones.size());
    for (const scene::Skin::Bone& bone : skin.bones) {
        writer.value(bone.node);
        writer.value(bone.node_from_mesh);
    }
    write_list(skin.first_weight, writer);
    write_list(skin.weights, writer);
}

scene::Skin::Bone read_bone(ByteReader& reader) {
    scene::Skin::Bone bone;
    bone.node = reader.value<std::uint32_t>();
    bone.node_from_mesh = reader.value<glm::dmat4>();
    return bone;
}

scene::Skin read_skin(ByteReader& reader) {
    scene::Skin skin;
    skin.mesh = reader.value<std::uint32_t>();
    reader.items(skin.positions);
    reader.items(skin.normals);
    read_all(reader, kBoneBytes, skin.bones, read_bone);
    reader.items(skin.first_weight);
    reader.items(skin.weights);
    return skin;
}

}  // namespace

void write_animation(const scene::Animation& animation, ByteWriter& writer) {
    writer.value(animation.duration_s);
    writer.value(animation.frames_per_s);
    writer.value<std::uint64_t>(animation.nodes.size());
    for (const scene::AnimatedNode& node : animation.nodes)
        write_node(node, writer);
    write_list(animation.node_of_instance, writer);
    writer.value<std::uint64_t>(animation.vertex_frames.size());
    for (const scene::VertexFrames& frames : animation.vertex_frames)
        write_frames(frames, writer);
    writer.value<std::uint64_t>(animation.skins.size());
    for (const scene::Skin& skin : animation.skins)
        write_skin(skin, writer);
}

scene::Animation read_animation(ByteReader& reader) {
    scene::Animation animation;
    animation.duration_s = reader.value<double>();
    animation.frames_per_s = reader.value<double>();
    read_all(reader, kLeastNodeBytes, animation.nodes, read_node);
    reader.items(animation.node_of_instance);
    read_all(reader, kLeastFramesBytes, animation.vertex_frames, read_frames);
    read_all(reader, kLeastSkinBytes, animation.skins, read_skin);
    return animation;
}

}  // namespace ink::import
