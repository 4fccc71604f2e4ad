#include "scene/camera_3ds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>
#include <optional>

namespace ink::scene {
namespace {

using Bytes = std::span<const std::byte>;

// Chunk ids of the 3D Studio format.
constexpr std::uint16_t kMain = 0x4d4d;
constexpr std::uint16_t kEditor = 0x3d3d;
constexpr std::uint16_t kNamedObject = 0x4000;
constexpr std::uint16_t kCamera = 0x4700;

constexpr std::size_t kHeaderBytes = 6;
constexpr double kLensDegrees = 2400;
constexpr double kPictureAspect = 4.0 / 3.0;

struct Chunk {
    std::uint16_t id = 0;
    Bytes body;
};

/// Takes the first chunk off `bytes`, cut to what is there; nothing if not even a header is left.
std::optional<Chunk> take_chunk(Bytes& bytes) {
    if (bytes.size() < kHeaderBytes) return std::nullopt;
    Chunk chunk;
    std::uint32_t length = 0;
    std::memcpy(&chunk.id, bytes.data(), 2);
    std::memcpy(&length, bytes.data() + 2, 4);
    if (length < kHeaderBytes) return std::nullopt;
    const std::size_t end = std::min<std::size_t>(length, bytes.size());
    chunk.body = bytes.subspan(kHeaderBytes, end - kHeaderBytes);
    bytes = bytes.subspan(end);
    return chunk;
}

/// Takes the zero-ended name in front of an object's chunks.
std::string take_name(Bytes& bytes) {
    std::string name;
    while (!bytes.empty() && bytes.front() != std::byte{0}) {
        name.push_back(static_cast<char>(bytes.front()));
        bytes = bytes.subspan(1);
    }
    if (!bytes.empty()) bytes = bytes.subspan(1);
    return name;
}

/// `up` turned about the unit vector `axis` (Rodrigues).
glm::dvec3 turned(const glm::dvec3& up, const glm::dvec3& axis, double angle_rad) {
    return up * std::cos(angle_rad) + glm::cross(axis, up) * std::sin(angle_rad) +
           axis * glm::dot(axis, up) * (1 - std::cos(angle_rad));
}

/// The camera in a camera chunk's body: eye, target, roll in degrees, lens in millimetres.
std::optional<ImportedCamera> parse_camera(Bytes body, const std::string& name) {
    std::array<float, 8> f{};
    if (body.size() < sizeof f) return std::nullopt;
    std::memcpy(f.data(), body.data(), sizeof f);
    ImportedCamera camera{
        .name = name, .eye_world = {f[0], f[1], f[2]}, .target_world = {f[3], f[4], f[5]}};
    constexpr double kDegree = std::numbers::pi / 180;
    const glm::dvec3 gaze = camera.target_world - camera.eye_world;
    camera.up_world = {0, 0, 1};
    if (glm::length(gaze) > 0) {
        camera.up_world = turned(camera.up_world, glm::normalize(gaze), f[6] * kDegree);
    }
    const double fov_x_rad = kLensDegrees / f[7] * kDegree;
    if (!(fov_x_rad > 0 && fov_x_rad < std::numbers::pi)) return std::nullopt;
    camera.fov_y_rad = 2 * std::atan(std::tan(fov_x_rad / 2) / kPictureAspect);
    return camera;
}

void collect_cameras(Bytes object, std::vector<ImportedCamera>& cameras) {
    const std::string name = take_name(object);
    while (const auto chunk = take_chunk(object)) {
        if (chunk->id != kCamera) continue;
        if (auto camera = parse_camera(chunk->body, name)) cameras.push_back(std::move(*camera));
    }
}

}  // namespace

std::vector<ImportedCamera> read_3ds_cameras(std::span<const std::byte> file) {
    std::vector<ImportedCamera> cameras;
    const auto main = take_chunk(file);
    if (!main || main->id != kMain) return cameras;
    Bytes sections = main->body;
    while (auto section = take_chunk(sections)) {
        if (section->id != kEditor) continue;
        while (const auto chunk = take_chunk(section->body)) {
            if (chunk->id == kNamedObject) collect_cameras(chunk->body, cameras);
        }
    }
    return cameras;
}

std::vector<ImportedCamera> read_3ds_cameras(const std::filesystem::path& path,
                                             const glm::dmat4& world_from_file) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<ImportedCamera> cameras = read_3ds_cameras(std::as_bytes(std::span(bytes)));
    for (ImportedCamera& camera : cameras) {
        camera.eye_world = world_from_file * glm::dvec4(camera.eye_world, 1);
        camera.target_world = world_from_file * glm::dvec4(camera.target_world, 1);
        camera.up_world = glm::dmat3(world_from_file) * camera.up_world;
    }
    return cameras;
}

}  // namespace ink::scene
