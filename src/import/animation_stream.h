#pragma once

#include "core/byte_stream.h"
#include "scene/animation.h"

// The parts of an animation in the import child's stream. What is read is not checked: anything at
// all where the reader fails.

namespace ink::import {

static_assert(sizeof(scene::VectorKey) == 32 && sizeof(scene::RotationKey) == 40 &&
                  sizeof(scene::WeightKey) == 16 && sizeof(scene::BoneWeight) == 8 &&
                  sizeof(scene::Course<glm::dvec3>::Tangents) == 48 &&
                  sizeof(scene::Course<glm::dquat>::Tangents) == 64 && sizeof(std::size_t) == 8,
              "arrays travel as they lie in memory, without gaps");

// The least that each kind takes in the stream, so that a claimed count can be judged.
inline constexpr std::size_t kLeastNodeBytes = 192;
inline constexpr std::size_t kLeastFramesBytes = 24;
inline constexpr std::size_t kLeastSkinBytes = 28;
inline constexpr std::size_t kBoneBytes = 132;
inline constexpr std::size_t kLeastMorphBytes = 12;
inline constexpr std::size_t kLeastTargetBytes = 44;

template <class Stream, class Keys, class Course>
void pass_keys(Stream& stream, Keys& keys, Course& course) {
    stream.parts(keys, course.interpolation, course.tangents);
}

/// Writes an animation, or reads it.
template <class Stream, class Animation>
void pass_animation(Stream& of, Animation& animation) {
    of.parts(animation.duration_s, animation.frames_per_s);
    of.list(animation.nodes, kLeastNodeBytes, [](Stream& stream, auto& node) {
        stream.parts(node.parent, node.parent_from_node);
        pass_keys(stream, node.translations, node.translation_course);
        pass_keys(stream, node.rotations, node.rotation_course);
        pass_keys(stream, node.scales, node.scale_course);
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
    of.list(animation.morphs, kLeastMorphBytes, [](Stream& stream, auto& morph) {
        stream.parts(morph.mesh);  // as of a skin
        stream.list(morph.targets, kLeastTargetBytes, [](Stream& targets, auto& target) {
            targets.parts(target.positions, target.normals, target.weight);
            pass_keys(targets, target.weights, target.course);
        });
    });
}

}  // namespace ink::import
