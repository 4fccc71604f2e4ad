#include "import/scene_stream.h"

#include <array>

#include "import/animation_stream.h"
#include "import/byte_stream.h"

namespace ink::import {
namespace {

constexpr std::array<char, 8> kMagic{'i', 'n', 'k', 's', 'c', 'e', 'n', 'e'};
constexpr std::uint32_t kVersion = 3;
constexpr std::uint32_t kEndMark = 0x656e6421;

static_assert(sizeof(glm::vec3) == 12 && sizeof(scene::Triangle) == 12,
              "arrays travel as they lie in memory");

void write_mesh(ByteWriter& writer, const scene::Mesh& mesh) {
    writer.text(mesh.name);
    writer.items(std::span<const glm::vec3>(mesh.positions));
    writer.items(std::span<const glm::vec3>(mesh.normals));
    writer.items(std::span<const scene::Triangle>(mesh.triangles));
    writer.value<std::uint32_t>(mesh.materials.empty() ? 0 : mesh.materials.front());
}

scene::Mesh read_mesh(ByteReader& reader) {
    scene::Mesh mesh;
    mesh.name = reader.text();
    reader.items(mesh.positions);
    reader.items(mesh.normals);
    reader.items(mesh.triangles);
    const auto material = reader.value<std::uint32_t>();
    if (material != 0) mesh.materials.assign(mesh.triangles.size(), material);
    return mesh;
}

void write_instance(ByteWriter& writer, const scene::Instance& instance) {
    writer.value(instance.mesh);
    writer.value(instance.world_from_object);
    writer.text(instance.name);
}

scene::Instance read_instance(ByteReader& reader) {
    scene::Instance instance;
    instance.mesh = reader.value<std::uint32_t>();
    instance.world_from_object = reader.value<glm::dmat4>();
    instance.name = reader.text();
    return instance;
}

void write_camera(ByteWriter& writer, const ImportedCamera& camera) {
    writer.text(camera.name);
    writer.value(camera.eye_world);
    writer.value(camera.target_world);
    writer.value(camera.up_world);
    writer.value(camera.fov_y_rad);
    writer.value(camera.motion.eye_node);
    writer.value(camera.motion.target_node);
    writer.value(camera.motion.p_eye);
    writer.value(camera.motion.p_target);
    writer.value(camera.motion.up);
}

ImportedCamera read_camera(ByteReader& reader) {
    ImportedCamera camera;
    camera.name = reader.text();
    camera.eye_world = reader.value<glm::dvec3>();
    camera.target_world = reader.value<glm::dvec3>();
    camera.up_world = reader.value<glm::dvec3>();
    camera.fov_y_rad = reader.value<double>();
    camera.motion.eye_node = reader.value<std::uint32_t>();
    camera.motion.target_node = reader.value<std::uint32_t>();
    camera.motion.p_eye = reader.value<glm::dvec3>();
    camera.motion.p_target = reader.value<glm::dvec3>();
    camera.motion.up = reader.value<glm::dvec3>();
    return camera;
}

// The least that each kind takes in the stream, so that a claimed count can be judged.
constexpr std::size_t kLeastMeshBytes = 36;
constexpr std::size_t kLeastInstanceBytes = 140;
constexpr std::size_t kLeastCameraBytes = 168;

}  // namespace

void write_reply(const ImportReply& reply, const ByteSink& sink) {
    ByteWriter writer(sink);
    writer.value(kMagic);
    writer.value(kVersion);
    writer.value(reply.status);
    writer.text(reply.reason);
    writer.value(reply.faces_read);
    writer.value(reply.vertices_read);
    writer.value<std::uint64_t>(reply.meshes.size());
    for (const scene::Mesh& mesh : reply.meshes)
        write_mesh(writer, mesh);
    writer.value<std::uint64_t>(reply.instances.size());
    for (const scene::Instance& instance : reply.instances)
        write_instance(writer, instance);
    writer.value<std::uint64_t>(reply.cameras.size());
    for (const ImportedCamera& camera : reply.cameras)
        write_camera(writer, camera);
    writer.value<std::uint32_t>(reply.animation ? 1 : 0);
    if (reply.animation) write_animation(*reply.animation, writer);
    writer.value(kEndMark);
}

std::optional<ImportReply> read_reply(std::span<const std::byte> stream) {
    ByteReader reader(stream);
    if (reader.value<std::array<char, 8>>() != kMagic) return std::nullopt;
    if (reader.value<std::uint32_t>() != kVersion) return std::nullopt;
    ImportReply reply;
    const auto status = reader.value<std::uint32_t>();
    if (status > static_cast<std::uint32_t>(ImportStatus::out_of_memory)) return std::nullopt;
    reply.status = static_cast<ImportStatus>(status);
    reply.reason = reader.text();
    reply.faces_read = reader.value<std::uint64_t>();
    reply.vertices_read = reader.value<std::uint64_t>();
    read_all(reader, kLeastMeshBytes, reply.meshes, read_mesh);
    read_all(reader, kLeastInstanceBytes, reply.instances, read_instance);
    read_all(reader, kLeastCameraBytes, reply.cameras, read_camera);
    const auto animations = reader.value<std::uint32_t>();
    if (animations > 1) return std::nullopt;
    if (animations == 1) reply.animation = read_animation(reader);
    if (reader.value<std::uint32_t>() != kEndMark || !reader.at_end()) return std::nullopt;
    return reply;
}

}  // namespace ink::import
