#include "import/camera_3ds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace ink::import {
namespace {

using Bytes = std::span<const std::byte>;

// Chunk ids of the 3D Studio format.
constexpr std::uint16_t kMain = 0x4d4d;
constexpr std::uint16_t kEditor = 0x3d3d;
constexpr std::uint16_t kNamedObject = 0x4000;
constexpr std::uint16_t kCamera = 0x4700;

constexpr std::uint16_t kKeyframer = 0xb000;
constexpr std::uint16_t kCameraNode = 0xb003;
constexpr std::uint16_t kTargetNode = 0xb004;
constexpr std::uint16_t kNodeHeader = 0xb010;
constexpr std::uint16_t kPositionTrack = 0xb020;

constexpr std::size_t kHeaderBytes = 6;
constexpr double kFramesPerSecond = 30;  // no file names a rate
constexpr double kLensDegrees = 2400;
constexpr double kImageAspect = 4.0 / 3.0;

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
    const glm::dvec3 view_direction = camera.target_world - camera.eye_world;
    camera.up_world = {0, 0, 1};
    if (glm::length(view_direction) > 0) {
        camera.up_world = turned(camera.up_world, glm::normalize(view_direction), f[6] * kDegree);
    }
    const double fov_x_rad = kLensDegrees / f[7] * kDegree;
    if (!(fov_x_rad > 0 && fov_x_rad < std::numbers::pi)) return std::nullopt;
    camera.fov_y_rad = 2 * std::atan(std::tan(fov_x_rad / 2) / kImageAspect);
    return camera;
}

void collect_cameras(Bytes object, std::vector<ImportedCamera>& cameras) {
    const std::string name = take_name(object);
    while (const auto chunk = take_chunk(object)) {
        if (chunk->id != kCamera) continue;
        if (auto camera = parse_camera(chunk->body, name)) cameras.push_back(std::move(*camera));
    }
}

template <class T>
T value_at(Bytes bytes, std::size_t offset) {
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// A track of positions: 10 bytes of flags, a count, and for each key its frame, what eases it (a
/// float for each of five bits) and the place.
std::vector<scene::VectorKey> parse_positions(Bytes body) {
    constexpr std::size_t kTrackHeader = 14;
    constexpr std::size_t kKeyHeader = 6;
    constexpr std::size_t kPlace = 12;
    std::vector<scene::VectorKey> keys;
    if (body.size() < kTrackHeader) return keys;
    const auto count = value_at<std::uint32_t>(body, kTrackHeader - 4);
    std::size_t at = kTrackHeader;
    while (keys.size() < count && body.size() - at >= kKeyHeader) {
        const double time_s = value_at<std::uint32_t>(body, at) / kFramesPerSecond;
        const unsigned easing = value_at<std::uint16_t>(body, at + 4) & 0x1fU;
        at += kKeyHeader + 4 * static_cast<std::size_t>(std::popcount(easing));
        if (at > body.size() || body.size() - at < kPlace) break;
        const auto place = value_at<std::array<float, 3>>(body, at);
        at += kPlace;
        if (!keys.empty() && time_s < keys.back().time_s) break;
        keys.push_back({time_s, {place[0], place[1], place[2]}});
    }
    return keys;
}

/// The name and the keys of a node of the keyframer; no keys if it hangs on another.
std::pair<std::string, std::vector<scene::VectorKey>> parse_node(Bytes node) {
    constexpr std::int16_t kNoParent = -1;
    constexpr std::size_t kParent = 4;  // behind two flags
    std::string name;
    std::vector<scene::VectorKey> keys;
    bool is_free = false;
    while (const auto chunk = take_chunk(node)) {
        Bytes body = chunk->body;
        if (chunk->id == kNodeHeader) {
            name = take_name(body);
            is_free =
                body.size() >= kParent + 2 && value_at<std::int16_t>(body, kParent) == kNoParent;
        }
        if (chunk->id == kPositionTrack) keys = parse_positions(body);
    }
    if (!is_free) keys.clear();
    return {name, keys};
}

/// A node under the root that goes by `keys`, at `rest` without them.
std::uint32_t add_node(const std::vector<scene::VectorKey>& keys,
                       const glm::dvec3& rest,
                       scene::Animation& motion) {
    scene::AnimatedNode node{0, glm::translate(glm::dmat4(1), rest), {}, {}, {}};
    if (!keys.empty()) {
        node.translations = keys;
        node.rotations = {{0, {1, 0, 0, 0}}};
        node.scales = {{0, glm::dvec3(1)}};
        if (keys.size() > 1) motion.duration_s = std::max(motion.duration_s, keys.back().time_s);
    }
    motion.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(motion.nodes.size() - 1);
}

/// Hangs the camera, still in file space, on nodes of its own.
void hang(const CameraKeys& keys, ImportedCamera& camera, scene::Animation& motion) {
    if (std::max(keys.eye.size(), keys.target.size()) < 2) return;
    camera.motion.eye_node = add_node(keys.eye, camera.eye_world, motion);
    camera.motion.target_node = add_node(keys.target, camera.target_world, motion);
    camera.motion.up = camera.up_world;
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

std::vector<CameraKeys> read_3ds_camera_keys(std::span<const std::byte> file) {
    std::vector<CameraKeys> cameras;
    const auto of = [&](const std::string& name) -> CameraKeys& {
        const auto known = std::find_if(
            cameras.begin(), cameras.end(), [&](const CameraKeys& c) { return c.name == name; });
        return known == cameras.end() ? cameras.emplace_back(CameraKeys{name, {}, {}}) : *known;
    };
    const auto main = take_chunk(file);
    if (!main || main->id != kMain) return cameras;
    Bytes sections = main->body;
    while (auto section = take_chunk(sections)) {
        if (section->id != kKeyframer) continue;
        while (const auto chunk = take_chunk(section->body)) {
            if (chunk->id != kCameraNode && chunk->id != kTargetNode) continue;
            auto [name, keys] = parse_node(chunk->body);
            (chunk->id == kCameraNode ? of(name).eye : of(name).target) = std::move(keys);
        }
    }
    return cameras;
}

std::vector<ImportedCamera> read_3ds_cameras(const std::filesystem::path& path,
                                             scene::Animation& motion) {
    const glm::dmat4 world_from_file = motion.nodes.front().parent_from_node;
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<ImportedCamera> cameras = read_3ds_cameras(std::as_bytes(std::span(bytes)));
    const std::vector<CameraKeys> all_keys = read_3ds_camera_keys(std::as_bytes(std::span(bytes)));
    for (ImportedCamera& camera : cameras) {
        for (const CameraKeys& keys : all_keys) {
            if (keys.name == camera.name) hang(keys, camera, motion);
        }
        camera.eye_world = world_from_file * glm::dvec4(camera.eye_world, 1);
        camera.target_world = world_from_file * glm::dvec4(camera.target_world, 1);
        camera.up_world = glm::dmat3(world_from_file) * camera.up_world;
    }
    return cameras;
}

}  // namespace ink::import
