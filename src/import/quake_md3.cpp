// Quake III's MD3, version 15: surfaces with vertices per frame, and tags, places per frame on
// which other models hang. A player is three files: lower carries upper on tag_torso, upper carries
// head on tag_head.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "import/quake_models.h"

namespace ink::import {
namespace {

// Of most of a player's moves; animation.cfg has a rate for each, from 5 to 30.
constexpr double kMd3FramesPerSecond = 15;
constexpr float kUnit = 1.0F / 64;
constexpr std::uint64_t kSurfaceHeadBytes = 108;
constexpr std::uint64_t kTagBytes = 112;  // name of 64 characters, origin, three axes
constexpr std::uint64_t kVertexBytes = 8;
constexpr std::uint64_t kTriangleBytes = 12;
constexpr std::size_t kNameChars = 64;

/// The tags that carry the next part.
constexpr const char* kCarriers[] = {"tag_torso", "tag_head"};

/// A normal as two bytes: angle from z, then about it, each of 256 steps a turn.
glm::vec3 unpacked_normal(std::uint16_t packed) {
    constexpr double kStep_rad = 2 * std::numbers::pi / 256;
    const double about_rad = (packed >> 8) * kStep_rad;
    const double from_z_rad = (packed & 255) * kStep_rad;
    return glm::dvec3(std::cos(about_rad) * std::sin(from_z_rad),
                      std::sin(about_rad) * std::sin(from_z_rad),
                      std::cos(from_z_rad));
}

/// A surface's place in the file: all of it lies within, so that the file's size bounds the
/// scene's.
struct Surface {
    const ModelBytes& file;
    std::uint64_t start = 0;
    std::uint64_t end = 0;

    /// Where the list begins whose offset stands at `field`.
    [[nodiscard]] std::uint64_t list(std::uint64_t field,
                                     std::uint64_t count,
                                     std::uint64_t each,
                                     const std::string& what) const {
        const std::uint64_t offset = file.count_at(start + field, "as the offset of " + what, 0);
        if (offset > end - start || count > (end - start - offset) / each) {
            file.fail(start + field,
                      std::to_string(count) + ' ' + what + " do not fit into their surface",
                      std::to_string(each) + " bytes each, " + std::to_string(end - start) +
                          " bytes in all");
        }
        return start + offset;
    }
};

std::vector<scene::Triangle> read_triangles(const Surface& surface, std::uint64_t vertices) {
    const std::uint64_t count = surface.file.count_at(surface.start + 84, "triangles", 0);
    const std::uint64_t offset = surface.list(88, count, kTriangleBytes, "triangles");
    return quake_triangles<std::int32_t>(surface.file, offset, count, kTriangleBytes, vertices);
}

scene::VertexFrames read_frames(const Surface& surface, std::uint64_t vertices) {
    const ModelBytes& file = surface.file;
    scene::VertexFrames frames;
    frames.frame_count = file.count_at(surface.start + 72, "frames", 1);
    const std::uint64_t count = frames.frame_count * vertices;  // both below 2^31
    const std::uint64_t offset = surface.list(100, count, kVertexBytes, "vertices");
    for (std::uint64_t v = 0; v < count; ++v) {
        const std::uint64_t at = offset + v * kVertexBytes;
        frames.positions.emplace_back(file.at<std::int16_t>(at) * kUnit,
                                      file.at<std::int16_t>(at + 2) * kUnit,
                                      file.at<std::int16_t>(at + 4) * kUnit);
        frames.normals.push_back(unpacked_normal(file.at<std::uint16_t>(at + 6)));
    }
    return frames;
}

/// A player as it is put together.
struct Assembly {
    ImportReply reply;
    scene::Animation animation;
};

/// Adds the surfaces of `part` at `node`; empty ones are left out.
void add_surfaces(const Md3File& part, std::uint32_t node, Assembly& whole) {
    const ModelBytes& file = part.bytes;
    const std::uint64_t surfaces = file.count_at(84, "surfaces", 1);
    std::uint64_t start = file.count_at(100, "as the surfaces' offset", 0);
    for (std::uint64_t s = 0; s < surfaces; ++s) {
        file.need(start, 1, kSurfaceHeadBytes, "surface");
        const std::uint64_t bytes = file.count_at(start + 104, "bytes of a surface", 108);
        file.need(start, bytes, 1, "bytes of a surface");
        const Surface surface{file, start, start + bytes};
        start += bytes;
        const std::uint64_t vertices = file.count_at(surface.start + 80, "vertices", 0);
        ImportedMesh mesh;
        mesh.name = file.text_at(surface.start + 4, kNameChars);
        mesh.triangles = read_triangles(surface, vertices);
        if (mesh.triangles.empty()) continue;
        scene::VertexFrames frames = read_frames(surface, vertices);
        const auto first = static_cast<std::ptrdiff_t>(vertices);
        mesh.positions.assign(frames.positions.begin(), frames.positions.begin() + first);
        mesh.normals.assign(frames.normals.begin(), frames.normals.begin() + first);
        const auto number = static_cast<std::uint32_t>(whole.reply.meshes.size());
        mesh.parts = {{.material = number}};
        whole.reply.instances.push_back({number, glm::dmat4(1), part.part + '/' + mesh.name});
        whole.reply.meshes.push_back(std::move(mesh));
        whole.animation.node_of_instance.push_back(node);
        whole.animation.vertex_frames.push_back(std::move(frames));
    }
}

/// The rotation and the lengths in a tag's axes.
void add_tag_key(const ModelBytes& file,
                 std::uint64_t at,
                 double time_s,
                 scene::AnimatedNode& node) {
    glm::dmat3 axes;
    glm::dvec3 lengths;
    for (int a = 0; a < 3; ++a) {
        axes[a] = file.at<glm::vec3>(at + 12 + 12 * static_cast<std::uint64_t>(a));
        lengths[a] = glm::length(axes[a]);
        if (!(lengths[a] > 1e-6 && lengths[a] < 1e6)) {
            file.fail(at + 12, "a tag whose axes have no good length", "three unit vectors");
        }
        axes[a] /= lengths[a];
    }
    if (glm::determinant(axes) < 0) {
        axes = -axes;
        lengths = -lengths;
    }
    node.translations.push_back({time_s, file.at<glm::vec3>(at)});
    node.rotations.push_back({time_s, glm::normalize(glm::quat_cast(axes))});
    node.scales.push_back({time_s, lengths});
}

/// The tag called `name` as a node under `parent`, with a key a frame.
scene::AnimatedNode read_tag(const Md3File& part, const std::string& name, std::uint32_t parent) {
    const ModelBytes& file = part.bytes;
    const std::uint64_t frames = file.count_at(76, "frames", 1);
    const std::uint64_t tags = file.count_at(80, "tags", 0);
    const std::uint64_t offset = file.count_at(96, "as the tags' offset", 0);
    file.need(offset, frames * tags, kTagBytes, "tags");
    std::uint64_t number = 0;
    while (number < tags && file.text_at(offset + number * kTagBytes, kNameChars) != name)
        ++number;
    if (number == tags) {
        file.fail(80, std::to_string(tags) + " tags, none called " + name, "a tag of that name");
    }
    scene::AnimatedNode node;
    node.parent = parent;
    for (std::uint64_t f = 0; f < frames; ++f) {
        const std::uint64_t at = offset + (f * tags + number) * kTagBytes + kNameChars;
        add_tag_key(file, at, static_cast<double>(f) / kMd3FramesPerSecond, node);
    }
    node.parent_from_node = node.at(0);
    return node;
}

/// Puts the instances where their nodes are at rest, and hands over the motion if there is any.
void finish(Assembly& whole) {
    const std::vector<glm::dmat4> world = scene::world_from_nodes(whole.animation, std::nullopt);
    for (std::size_t i = 0; i < whole.reply.instances.size(); ++i)
        whole.reply.instances[i].world_from_object = world[whole.animation.node_of_instance[i]];
    std::size_t frames = whole.animation.frame_count();
    for (const scene::AnimatedNode& node : whole.animation.nodes)
        frames = std::max(frames, node.translations.size());
    if (frames < 2) return;
    whole.animation.frames_per_s = kMd3FramesPerSecond;
    whole.animation.duration_s = static_cast<double>(frames - 1) / kMd3FramesPerSecond;
    whole.reply.animation = std::move(whole.animation);
}

}  // namespace

ImportReply read_md3(const std::vector<Md3File>& files) {
    Assembly whole;
    whole.animation.nodes.push_back({scene::kNoNode, y_up_from_quake(), {}, {}, {}});
    for (std::size_t f = 0; f < files.size(); ++f) {
        const auto node = static_cast<std::uint32_t>(f);
        if (f > 0)
            whole.animation.nodes.push_back(read_tag(files[f - 1], kCarriers[f - 1], node - 1));
        add_surfaces(files[f], node, whole);
    }
    finish(whole);
    return std::move(whole.reply);
}

}  // namespace ink::import
