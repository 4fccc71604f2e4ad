#include "import/stage_3ds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "core/named.h"
#include "import/chunks_3ds.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

constexpr std::uint16_t kNamedObject = 0x4000;

// Chunk ids of the 3D Studio format, for cameras.
constexpr std::uint16_t kCamera = 0x4700;
constexpr std::uint16_t kCameraNode = 0xb003;
constexpr std::uint16_t kTargetNode = 0xb004;

constexpr double kLensDegrees = 2400;
constexpr double kImageAspect = 4.0 / 3.0;

/// What `parse` makes of each object's chunks of the kind `id`.
template <class Parse>
auto all_parsed(std::span<const std::byte> file, std::uint16_t id, Parse parse) {
    std::vector<typename std::invoke_result_t<Parse, decltype(file), std::string>::value_type> all;
    for (Chunk3ds& object : chunks_of(file, kEditor3ds)) {
        if (object.id != kNamedObject) continue;
        const std::string name = take_name(object.body);
        while (const auto chunk = take_chunk(object.body)) {
            if (chunk->id != id) continue;
            if (auto parsed = parse(chunk->body, name)) all.push_back(std::move(*parsed));
        }
    }
    return all;
}

/// `up` turned about the unit vector `axis` (Rodrigues).
glm::dvec3 turned(const glm::dvec3& up, const glm::dvec3& axis, double angle_rad) {
    return up * std::cos(angle_rad) + glm::cross(axis, up) * std::sin(angle_rad) +
           axis * glm::dot(axis, up) * (1 - std::cos(angle_rad));
}

/// The camera in a camera chunk's body: eye, target, roll in degrees, lens in millimetres.
std::optional<ImportedCamera> parse_camera(std::span<const std::byte> body,
                                           const std::string& name) {
    using Eight = std::array<float, 8>;
    if (body.size() < sizeof(Eight)) return std::nullopt;
    const auto f = number_at<Eight>(body, 0);
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

// And for lights.
constexpr std::uint16_t kLight = 0x4600;
constexpr std::uint16_t kSpot = 0x4610;
constexpr std::uint16_t kOff = 0x4620;
constexpr std::uint16_t kThinsOut = 0x4625;
constexpr std::uint16_t kExcluded = 0x4654;
constexpr std::uint16_t kInnerRange = 0x4659;
constexpr std::uint16_t kOuterRange = 0x465a;
constexpr std::uint16_t kMultiplier = 0x465b;
constexpr std::uint16_t kColor = 0x0010;  // three floats
constexpr std::uint16_t kColorBytes = 0x0011;
constexpr std::uint16_t kLinearColorBytes = 0x0012;
constexpr std::uint16_t kLinearColor = 0x0013;
constexpr std::uint16_t kLightNode = 0xb005;
constexpr std::uint16_t kSpotNode = 0xb007;

/// What stands in a chunk of a single number, or of three; 0 where it is cut.
float number_in(std::span<const std::byte> body) {
    return body.size() < sizeof(float) ? 0 : number_at<float>(body, 0);
}

template <class Number = float>
glm::vec3 vector_in(std::span<const std::byte> body) {
    using Three = std::array<Number, 3>;
    if (body.size() < sizeof(Three)) return glm::vec3(0);
    const auto v = number_at<Three>(body, 0);
    return {v[0], v[1], v[2]};
}

/// A light and what there is to say of it.
struct Light3ds {
    std::string name;
    ImportedLight light;
    float multiplier = 1;
    bool has_excluded = false;
};

/// The light in a light chunk's body: its place, then chunks; nothing if it is switched off.
std::optional<Light3ds> parse_light(std::span<const std::byte> body, const std::string& name) {
    constexpr std::size_t kPlace = 12;
    if (body.size() < kPlace) return std::nullopt;
    Light3ds found;
    ImportedLight& light = found.light;
    found.name = name;
    light.p_world = vector_in(body);
    bool thins_out = false;
    body = body.subspan(kPlace);
    while (const auto chunk = take_chunk(body)) {
        const auto [id, content] = *chunk;
        if (id == kOff) return std::nullopt;
        if (id == kSpot) light.kind = LightKind::spot;
        if (id == kThinsOut) thins_out = true;
        if (id == kExcluded) found.has_excluded = true;
        if (id == kInnerRange) light.inner_range = number_in(content);
        if (id == kOuterRange) light.range = number_in(content);
        if (id == kMultiplier) found.multiplier = number_in(content);
        if (id == kColor || id == kLinearColor) light.color = vector_in(content);
        if (id == kColorBytes || id == kLinearColorBytes)
            light.color = vector_in<std::uint8_t>(content) / 255.0F;
    }
    light.color *= found.multiplier;
    if (!thins_out) light.inner_range = light.range = 0;
    return found;
}

/// Hangs the light, still in file space, on a node of its own.
void hang(const Track3ds& track, Light3ds& light, scene::Animation& motion) {
    if (track.places.size() > 1)
        light.light.node = add_node_3ds(track.places, light.light.p_world, motion);
    if (track.colors.size() < 2) return;
    motion.duration_s = std::max(motion.duration_s, track.colors.back().time_s);
    light.light.colors = track.colors;
    for (scene::VectorKey& key : light.light.colors)
        key.value *= light.multiplier;
}

void note(const char* what, std::size_t count, std::vector<std::string>& notes) {
    if (count > 0) notes.push_back(what + std::to_string(count));
}

}  // namespace

std::vector<ImportedCamera> read_3ds_cameras(std::span<const std::byte> file) {
    return all_parsed(file, kCamera, parse_camera);
}

std::vector<CameraKeys> read_3ds_camera_keys(std::span<const std::byte> file) {
    std::vector<CameraKeys> cameras;
    const auto of = [&](const std::string& name) -> CameraKeys& {
        CameraKeys* known = core::find_named(cameras, name);
        return known == nullptr ? cameras.emplace_back(CameraKeys{name, {}, {}}) : *known;
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
        if (const auto* keys = core::find_named(all_keys, camera.name)) hang(*keys, camera, motion);
        camera.eye_world = world_from_file * glm::dvec4(camera.eye_world, 1);
        camera.target_world = world_from_file * glm::dvec4(camera.target_world, 1);
        camera.up_world = glm::dmat3(world_from_file) * camera.up_world;
    }
    return cameras;
}

std::vector<ImportedLight> read_3ds_lights(std::span<const std::byte> file) {
    std::vector<ImportedLight> lights;
    for (Light3ds& found : all_parsed(file, kLight, parse_light))
        lights.push_back(std::move(found.light));
    return lights;
}

std::vector<ImportedLight> read_3ds_lights(const std::filesystem::path& path,
                                           scene::Animation& motion,
                                           std::vector<std::string>& notes) {
    const glm::dmat4 world_from_file = motion.nodes.front().parent_from_node;
    const double stretch = std::cbrt(std::abs(glm::determinant(glm::dmat3(world_from_file))));
    const std::vector<std::byte> file = bytes_of(path);
    const std::vector<Track3ds> tracks = tracks_of(file);
    std::vector<ImportedLight> lights;
    std::size_t excluding = 0;
    std::size_t hung = 0;
    for (Light3ds& found : all_parsed(file, kLight, parse_light)) {
        for (const Track3ds& track : tracks) {
            const bool is_its =
                track.name == found.name && (track.id == kLightNode || track.id == kSpotNode);
            if (is_its && track.is_hung) ++hung;
            if (is_its && !track.is_hung) hang(track, found, motion);
        }
        excluding += found.has_excluded ? 1 : 0;
        ImportedLight& light = found.light;
        light.p_world = world_from_file * glm::dvec4(light.p_world, 1);
        light.range *= stretch;
        light.inner_range *= stretch;
        lights.push_back(std::move(light));
    }
    note("lights that hang on an object and do not go with it: ", hung, notes);
    note("lights that shine on the objects that they exclude, too: ", excluding, notes);
    return lights;
}

}  // namespace ink::import
