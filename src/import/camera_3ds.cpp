#include "import/camera_3ds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "import/chunks_3ds.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

// Chunk ids of the 3D Studio format.
constexpr std::uint16_t kCamera = 0x4700;
constexpr std::uint16_t kCameraNode = 0xb003;
constexpr std::uint16_t kTargetNode = 0xb004;

constexpr double kLensDegrees = 2400;
constexpr double kImageAspect = 4.0 / 3.0;

/// `up` turned about the unit vector `axis` (Rodrigues).
glm::dvec3 turned(const glm::dvec3& up, const glm::dvec3& axis, double angle_rad) {
    return up * std::cos(angle_rad) + glm::cross(axis, up) * std::sin(angle_rad) +
           axis * glm::dot(axis, up) * (1 - std::cos(angle_rad));
}

/// The camera in a camera chunk's body: eye, target, roll in degrees, lens in millimetres.
std::optional<ImportedCamera> parse_camera(std::span<const std::byte> body,
                                           const std::string& name) {
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

/// Hangs the camera, still in file space, on nodes of its own.
void hang(const CameraKeys& keys, ImportedCamera& camera, scene::Animation& motion) {
    if (std::max(keys.eye.size(), keys.target.size()) < 2) return;
    camera.motion.eye_node = add_node_3ds(keys.eye, camera.eye_world, motion);
    camera.motion.target_node = add_node_3ds(keys.target, camera.target_world, motion);
    camera.motion.up = camera.up_world;
}

}  // namespace

std::vector<ImportedCamera> read_3ds_cameras(std::span<const std::byte> file) {
    std::vector<ImportedCamera> cameras;
    for (const Object3ds& object : objects_of(file)) {
        for (const Chunk3ds& chunk : object.chunks) {
            if (chunk.id != kCamera) continue;
            if (auto camera = parse_camera(chunk.body, object.name))
                cameras.push_back(std::move(*camera));
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
    for (Track3ds& track : tracks_of(file)) {
        if (track.id != kCameraNode && track.id != kTargetNode) continue;
        if (track.is_hung) track.places.clear();
        (track.id == kCameraNode ? of(track.name).eye : of(track.name).target) =
            std::move(track.places);
    }
    return cameras;
}

std::vector<ImportedCamera> read_3ds_cameras(const std::filesystem::path& path,
                                             scene::Animation& motion) {
    const glm::dmat4 world_from_file = motion.nodes.front().parent_from_node;
    const std::vector<std::byte> file = bytes_of(path);
    std::vector<ImportedCamera> cameras = read_3ds_cameras(file);
    const std::vector<CameraKeys> all_keys = read_3ds_camera_keys(file);
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
