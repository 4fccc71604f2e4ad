#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/model_bytes.h"
#include "scene/animation.h"

/// What the readers of a .3ds file's cameras and lights have in common. Damaged chunks end a
/// search: what was found until then holds.
namespace ink::import {

/// A piece of a file: some numbers, then further chunks, as its id has it.
struct Chunk3ds {
    std::uint16_t id = 0;
    std::span<const std::byte> body;
};

inline constexpr std::uint16_t kEditor3ds = 0x3d3d;
inline constexpr std::uint16_t kKeyframer3ds = 0xb000;

/// Takes the first chunk off `bytes`, cut to what is there; nothing if not even a header is left.
[[nodiscard]] std::optional<Chunk3ds> take_chunk(std::span<const std::byte>& bytes);

/// Takes the zero-ended name in front of an object's chunks.
[[nodiscard]] std::string take_name(std::span<const std::byte>& bytes);

/// The chunks of the file's sections that are called `section`, in the file's order.
[[nodiscard]] std::vector<Chunk3ds> chunks_of(std::span<const std::byte> file,
                                              std::uint16_t section);

/// What moves an object, file space, seconds. What eases in and out of a key (tension, continuity,
/// bias) is passed over; a key that goes back in time ends its list.
struct Track3ds {
    std::uint16_t id = 0;  ///< of its chunk: what it moves
    std::string name;      ///< of the object
    bool is_hung = true;   ///< on another object, whose way it goes with besides
    std::vector<scene::VectorKey> places;
    std::vector<scene::VectorKey> colors;
};
[[nodiscard]] std::vector<Track3ds> tracks_of(std::span<const std::byte> file);

/// The number of a new node under the root that goes by `keys`, at `rest` without them; what the
/// motion lasts grows to the last of several keys.
[[nodiscard]] std::uint32_t add_node_3ds(const std::vector<scene::VectorKey>& keys,
                                         const glm::dvec3& rest,
                                         scene::Animation& motion);

}  // namespace ink::import
