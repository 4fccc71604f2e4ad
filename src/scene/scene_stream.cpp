#include "scene/scene_stream.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

namespace ink::scene {
namespace {

constexpr std::array<char, 8> kMagic{'i', 'n', 'k', 's', 'c', 'e', 'n', 'e'};
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kEndMark = 0x656e6421;

static_assert(sizeof(glm::vec3) == 12 && sizeof(Triangle) == 12,
              "arrays travel as they lie in memory");

class Writer {
  public:
    explicit Writer(const ByteSink& sink) : sink_(sink) {}

    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        sink_(&v, sizeof v);
    }
    template <class T>
    void items(std::span<const T> v) {
        value<std::uint64_t>(v.size());
        if (!v.empty()) sink_(v.data(), v.size_bytes());
    }
    void text(const std::string& s) { items(std::span<const char>(s)); }

  private:
    const ByteSink& sink_;
};

/// Reads values until the bytes run out; from then on `ok` is false and all values are zero.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class T>
    T value() {
        static_assert(std::is_trivially_copyable_v<T>);
        T v{};
        if (left_.size() < sizeof v) return fail(), v;
        std::memcpy(&v, left_.data(), sizeof v);
        left_ = left_.subspan(sizeof v);
        return v;
    }
    /// How many things follow, each at least `least_bytes` long: a count that cannot be is a
    /// failure.
    std::size_t count(std::size_t least_bytes) {
        const auto n = value<std::uint64_t>();
        if (n > left_.size() / least_bytes) return fail(), 0;
        return static_cast<std::size_t>(n);
    }
    template <class T>
    void items(std::vector<T>& out) {
        out.resize(count(sizeof(T)));
        if (out.empty()) return;
        std::memcpy(out.data(), left_.data(), out.size() * sizeof(T));
        left_ = left_.subspan(out.size() * sizeof(T));
    }
    std::string text() {
        std::vector<char> characters;
        items(characters);
        return {characters.begin(), characters.end()};
    }
    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] bool at_end() const { return ok_ && left_.empty(); }

  private:
    void fail() {
        ok_ = false;
        left_ = {};
    }
    std::span<const std::byte> left_;
    bool ok_ = true;
};

void write_mesh(Writer& writer, const Mesh& mesh) {
    writer.text(mesh.name);
    writer.items(std::span<const glm::vec3>(mesh.positions));
    writer.items(std::span<const glm::vec3>(mesh.normals));
    writer.items(std::span<const Triangle>(mesh.triangles));
    writer.value<std::uint32_t>(mesh.materials.empty() ? 0 : mesh.materials.front());
}

Mesh read_mesh(Reader& reader) {
    Mesh mesh;
    mesh.name = reader.text();
    reader.items(mesh.positions);
    reader.items(mesh.normals);
    reader.items(mesh.triangles);
    const auto material = reader.value<std::uint32_t>();
    if (material != 0) mesh.materials.assign(mesh.triangles.size(), material);
    return mesh;
}

void write_instance(Writer& writer, const Instance& instance) {
    writer.value(instance.mesh);
    writer.value(instance.world_from_object);
    writer.text(instance.name);
}

Instance read_instance(Reader& reader) {
    Instance instance;
    instance.mesh = reader.value<std::uint32_t>();
    instance.world_from_object = reader.value<glm::dmat4>();
    instance.name = reader.text();
    return instance;
}

void write_camera(Writer& writer, const ImportedCamera& camera) {
    writer.text(camera.name);
    writer.value(camera.eye_world);
    writer.value(camera.target_world);
    writer.value(camera.up_world);
    writer.value(camera.fov_y_rad);
}

ImportedCamera read_camera(Reader& reader) {
    ImportedCamera camera;
    camera.name = reader.text();
    camera.eye_world = reader.value<glm::dvec3>();
    camera.target_world = reader.value<glm::dvec3>();
    camera.up_world = reader.value<glm::dvec3>();
    camera.fov_y_rad = reader.value<double>();
    return camera;
}

// The least that each kind takes in the stream, so that a claimed count can be judged.
constexpr std::size_t kLeastMeshBytes = 36;
constexpr std::size_t kLeastInstanceBytes = 140;
constexpr std::size_t kLeastCameraBytes = 88;

template <class T, class Read>
void read_all(Reader& reader, std::size_t least_bytes, std::vector<T>& out, Read read) {
    const std::size_t n = reader.count(least_bytes);
    for (std::size_t i = 0; i < n && reader.ok(); ++i)
        out.push_back(read(reader));
}

}  // namespace

void write_reply(const ImportReply& reply, const ByteSink& sink) {
    Writer writer(sink);
    writer.value(kMagic);
    writer.value(kVersion);
    writer.value(reply.status);
    writer.text(reply.reason);
    writer.value(reply.faces_read);
    writer.value(reply.vertices_read);
    writer.value<std::uint64_t>(reply.meshes.size());
    for (const Mesh& mesh : reply.meshes)
        write_mesh(writer, mesh);
    writer.value<std::uint64_t>(reply.instances.size());
    for (const Instance& instance : reply.instances)
        write_instance(writer, instance);
    writer.value<std::uint64_t>(reply.cameras.size());
    for (const ImportedCamera& camera : reply.cameras)
        write_camera(writer, camera);
    writer.value(kEndMark);
}

std::optional<ImportReply> read_reply(std::span<const std::byte> stream) {
    Reader reader(stream);
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
    if (reader.value<std::uint32_t>() != kEndMark || !reader.at_end()) return std::nullopt;
    return reply;
}

}  // namespace ink::scene
