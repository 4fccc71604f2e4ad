#include "import/chunks_3ds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace ink::import {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::uint16_t kMain = 0x4d4d;
constexpr std::uint16_t kNodeHeader = 0xb010;
constexpr std::uint16_t kPlaces = 0xb020;
constexpr std::uint16_t kColors = 0xb025;

constexpr std::size_t kChunkHeadBytes = 6;
constexpr double k3dsFramesPerSecond = 30;  // no file names a rate

/// A track of places or colours: 10 bytes of flags, a count, and for each key its frame, what eases
/// it (a float for each of five bits) and its three numbers.
std::vector<scene::VectorKey> parse_keys(Bytes body) {
    constexpr std::size_t kTrackHeader = 14;
    constexpr std::size_t kKeyHeader = 6;
    constexpr std::size_t kValue = 12;
    std::vector<scene::VectorKey> keys;
    if (body.size() < kTrackHeader) return keys;
    const auto count = number_at<std::uint32_t>(body, kTrackHeader - 4);
    std::size_t at = kTrackHeader;
    while (keys.size() < count && body.size() - at >= kKeyHeader) {
        const double time_s = number_at<std::uint32_t>(body, at) / k3dsFramesPerSecond;
        const unsigned easing = number_at<std::uint16_t>(body, at + 4) & 0x1fU;
        at += kKeyHeader + 4 * static_cast<std::size_t>(std::popcount(easing));
        if (at > body.size() || body.size() - at < kValue) break;
        const auto value = number_at<std::array<float, 3>>(body, at);
        at += kValue;
        if (!keys.empty() && time_s < keys.back().time_s) break;
        keys.push_back({time_s, {value[0], value[1], value[2]}});
    }
    return keys;
}

Track3ds parse_track(const Chunk3ds& node) {
    constexpr std::int16_t kNoParent = -1;
    constexpr std::size_t kParent = 4;  // behind two flags
    Track3ds track;
    track.id = node.id;
    Bytes chunks = node.body;
    while (const auto chunk = take_chunk(chunks)) {
        Bytes body = chunk->body;
        if (chunk->id == kNodeHeader) {
            track.name = take_name(body);
            track.is_hung =
                body.size() < kParent + 2 || number_at<std::int16_t>(body, kParent) != kNoParent;
        }
        if (chunk->id == kPlaces) track.places = parse_keys(body);
        if (chunk->id == kColors) track.colors = parse_keys(body);
    }
    return track;
}

}  // namespace

std::optional<Chunk3ds> take_chunk(Bytes& bytes) {
    if (bytes.size() < kChunkHeadBytes) return std::nullopt;
    const auto length = number_at<std::uint32_t>(bytes, 2);
    if (length < kChunkHeadBytes) return std::nullopt;
    const std::size_t end = std::min<std::size_t>(length, bytes.size());
    const Chunk3ds chunk{number_at<std::uint16_t>(bytes, 0),
                         bytes.subspan(kChunkHeadBytes, end - kChunkHeadBytes)};
    bytes = bytes.subspan(end);
    return chunk;
}

std::string take_name(Bytes& bytes) {
    std::string name;
    while (!bytes.empty() && bytes.front() != std::byte{0}) {
        name.push_back(static_cast<char>(bytes.front()));
        bytes = bytes.subspan(1);
    }
    if (!bytes.empty()) bytes = bytes.subspan(1);
    return name;
}

std::vector<Chunk3ds> chunks_of(Bytes file, std::uint16_t section) {
    std::vector<Chunk3ds> chunks;
    const auto main = take_chunk(file);
    if (!main || main->id != kMain) return chunks;
    Bytes sections = main->body;
    while (auto found = take_chunk(sections)) {
        if (found->id != section) continue;
        while (const auto chunk = take_chunk(found->body))
            chunks.push_back(*chunk);
    }
    return chunks;
}

std::vector<Track3ds> tracks_of(Bytes file) {
    std::vector<Track3ds> tracks;
    for (const Chunk3ds& node : chunks_of(file, kKeyframer3ds))
        tracks.push_back(parse_track(node));
    return tracks;
}

std::uint32_t add_node_3ds(const std::vector<scene::VectorKey>& keys,
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

}  // namespace ink::import
