#include "import/scene_stream.h"

#include <algorithm>
#include <array>

#include "core/parse_number.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

// The parts of an animation. What is read is not checked: anything at all where the reader fails.

// The least that each kind takes in the stream, so that a claimed count can be judged.
constexpr std::size_t kLeastNodeBytes = 192;
constexpr std::size_t kLeastFramesBytes = 24;
constexpr std::size_t kLeastSkinBytes = 28;
constexpr std::size_t kBoneBytes = 132;
constexpr std::size_t kLeastMorphBytes = 12;
constexpr std::size_t kLeastTargetBytes = 44;

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

static_assert(sizeof(scene::VectorKey) == 32 && sizeof(scene::RotationKey) == 40 &&
                  sizeof(scene::WeightKey) == 16 && sizeof(scene::BoneWeight) == 8 &&
                  sizeof(scene::Course<glm::dvec3>::Tangents) == 48 &&
                  sizeof(scene::Course<glm::dquat>::Tangents) == 64 && sizeof(std::size_t) == 8,
              "arrays travel as they lie in memory, without gaps");

constexpr std::array<char, 8> kMagic{'i', 'n', 'k', 's', 'c', 'e', 'n', 'e'};
constexpr std::uint32_t kVersion = 8;
constexpr std::uint32_t kEndMark = 0x656e6421;

static_assert(sizeof(glm::vec2) == 8 && sizeof(glm::vec3) == 12 && sizeof(glm::vec4) == 16 &&
                  sizeof(glm::dvec3) == 24 && sizeof(scene::Triangle) == 12 &&
                  sizeof(MeshPart) == 16,
              "arrays travel as they lie in memory");

/// All between the status and whether there is an animation.
template <class Stream, class Reply>
void pass_scene(Stream& of, Reply& reply) {
    // The least that each kind takes in the stream, so that a claimed count can be judged.
    constexpr std::size_t kLeastMeshBytes = 57;
    constexpr std::size_t kLeastInstanceBytes = 144;
    constexpr std::size_t kLeastCameraBytes = 100;
    constexpr std::size_t kLeastLightBytes = 77;
    constexpr std::size_t kLeastTextBytes = 8;
    const auto pass_text = [](auto& stream, auto& text) { stream.parts(text); };
    of.parts(reply.reason);
    of.list(reply.meshes, kLeastMeshBytes, [](auto& stream, auto& mesh) {
        stream.parts(mesh.name, mesh.positions, mesh.normals, mesh.triangles, mesh.parts);
        stream.parts(mesh.marked_sides, mesh.are_floats, mesh.texcoords);
    });
    of.list(reply.instances, kLeastInstanceBytes, [](auto& stream, auto& instance) {
        stream.parts(instance.mesh, instance.world_from_object, instance.name, instance.file_node);
    });
    of.list(reply.cameras, kLeastCameraBytes, [](auto& stream, auto& camera) {
        stream.parts(camera.name, camera.eye_world, camera.target_world, camera.up_world);
        stream.parts(camera.fov_y_rad, camera.height_world, camera.node);
    });
    of.list(reply.lights, kLeastLightBytes, [](auto& stream, auto& light) {
        stream.parts(light.kind, light.p_world, light.direction_world, light.color);
        stream.parts(light.is_physical, light.range, light.node);
    });
    of.list(reply.animation_names, kLeastTextBytes, pass_text);
    of.list(reply.notes, kLeastTextBytes, pass_text);
    of.parts(reply.base_colors);
}

std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return "none, as the file has no animation";
    std::string list;
    for (const std::string& name : names)
        if (!name.empty()) list += name + ", ";
    return list + "or a number, 0.." + std::to_string(names.size() - 1);
}

}  // namespace

void write_reply(const ImportReply& reply, const core::ByteSink& sink) {
    core::ByteWriter writer(sink);
    writer.parts(kMagic, kVersion, reply.status);
    pass_scene(writer, reply);
    writer.parts(std::uint32_t{reply.animation ? 1U : 0U});
    if (reply.animation) pass_animation(writer, *reply.animation);
    writer.parts(kEndMark);
}

std::optional<ImportReply> read_reply(std::span<const std::byte> stream) {
    core::ByteReader reader(stream);
    if (reader.value<std::array<char, 8>>() != kMagic) return std::nullopt;
    if (reader.value<std::uint32_t>() != kVersion) return std::nullopt;
    ImportReply reply;
    const auto status = reader.value<std::uint32_t>();
    if (status > static_cast<std::uint32_t>(ImportStatus::out_of_memory)) return std::nullopt;
    reply.status = static_cast<ImportStatus>(status);
    pass_scene(reader, reply);
    const auto animations = reader.value<std::uint32_t>();
    if (animations > 1) return std::nullopt;
    if (animations == 1) pass_animation(reader, reply.animation.emplace());
    if (reader.value<std::uint32_t>() != kEndMark || !reader.is_at_end()) return std::nullopt;
    return reply;
}

std::size_t choose_animation(const std::vector<std::string>& names, const std::string& asked) {
    if (asked.empty()) return 0;
    const auto named = std::find(names.begin(), names.end(), asked);
    if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
    const auto number = core::parse_number<std::size_t>(asked);
    if (number && *number < names.size()) return *number;
    throw Refusal("", "it has no animation \"" + asked + '"', listed(names));
}

}  // namespace ink::import
