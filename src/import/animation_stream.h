#pragma once

#include "core/byte_stream.h"
#include "scene/animation.h"

// The parts of an animation in the import child's stream. What is read is not checked: anything at
// all where the reader fails.

namespace ink::import {

static_assert(sizeof(scene::VectorKey) == 32 && sizeof(scene::RotationKey) == 40 &&
                  sizeof(scene::BoneWeight) == 8 && sizeof(std::size_t) == 8,
              "arrays travel as they lie in memory, without gaps");

// The least that each kind takes in the stream, so that a claimed count can be judged.
inline constexpr std::size_t kLeastNodeBytes = 156;
inline constexpr std::size_t kLeastFramesBytes = 24;
inline constexpr std::size_t kLeastSkinBytes = 28;
inline constexpr std::size_t kBoneBytes = 132;

/// Writes an animation, or reads it.
template <class Stream, class Animation>
void pass_animation(Stream& of, Animation& animation) {
    of.parts(animation.duration_s, animation.frames_per_s);
    of.list(animation.nodes, kLeastNodeBytes, [](Stream& stream, auto& node) {
        stream.parts(
            node.parent, node.parent_from_node, node.translations, node.rotations, node.scales);
    });
    of.parts(animation.node_of_instance);
    of.list(animation.vertex_frames, kLeastFramesBytes, [](Stream& stream, auto& frames) {
        stream.parts(frames.frame_count, frames.positions, frames.normals);
    });
    of.list(animation.skins, kLeastSkinBytes, [](Stream& stream, auto& skin) {
        stream.parts(skin.mesh);  // its positions and normals are the mesh's
        stream.list(skin.bones, kBoneBytes, [](Stream& bones, auto& bone) {
            bones.parts(bone.node, bone.node_from_mesh);
        });
        stream.parts(skin.first_weight, skin.weights);
    });
}

}  // namespace ink::import
