#include "import/light_3ds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "import/chunks_3ds.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

// Chunk ids of the 3D Studio format.
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

glm::vec3 vector_in(std::span<const std::byte> body) {
    using Three = std::array<float, 3>;
    if (body.size() < sizeof(Three)) return glm::vec3(0);
    const auto f = number_at<Three>(body, 0);
    return {f[0], f[1], f[2]};
}

glm::vec3 color_bytes_in(std::span<const std::byte> body) {
    using Three = std::array<std::uint8_t, 3>;
    if (body.size() < sizeof(Three)) return glm::vec3(0);
    const auto b = number_at<Three>(body, 0);
    return glm::vec3(b[0], b[1], b[2]) / 255.0F;
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
        switch (chunk->id) {
            case kOff:
                return std::nullopt;
            case kSpot:
                light.kind = LightKind::spot;
                break;
            case kThinsOut:
                thins_out = true;
                break;
            case kExcluded:
                found.has_excluded = true;
                break;
            case kInnerRange:
                light.inner_range = number_in(chunk->body);
                break;
            case kOuterRange:
                light.range = number_in(chunk->body);
                break;
            case kMultiplier:
                found.multiplier = number_in(chunk->body);
                break;
            case kColor:
            case kLinearColor:
                light.color = vector_in(chunk->body);
                break;
            case kColorBytes:
            case kLinearColorBytes:
                light.color = color_bytes_in(chunk->body);
                break;
            default:
                break;
        }
    }
    light.color *= found.multiplier;
    if (!thins_out) light.inner_range = light.range = 0;
    return found;
}

std::vector<Light3ds> lights_of(std::span<const std::byte> file) {
    std::vector<Light3ds> lights;
    for (const Object3ds& object : objects_of(file)) {
        for (const Chunk3ds& chunk : object.chunks) {
            if (chunk.id != kLight) continue;
            if (auto light = parse_light(chunk.body, object.name))
                lights.push_back(std::move(*light));
        }
    }
    return lights;
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

std::vector<ImportedLight> read_3ds_lights(std::span<const std::byte> file) {
    std::vector<ImportedLight> lights;
    for (Light3ds& found : lights_of(file))
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
    for (Light3ds& found : lights_of(file)) {
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
