#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Pieces of .3ds files.

namespace ink::import {

template <class T>
std::string raw(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

inline std::string chunk(std::uint16_t id, const std::string& body) {
    return raw(id) + raw(static_cast<std::uint32_t>(body.size() + 6)) + body;
}

/// A named object of the editor section.
inline std::string object_3ds(const std::string& name, const std::string& chunks) {
    return chunk(0x4000, name + '\0' + chunks);
}

/// A file with these objects and these nodes of the keyframer.
inline std::string file_3ds(const std::string& objects, const std::string& nodes = "") {
    const std::string keyframer = nodes.empty() ? "" : chunk(0xb000, nodes);
    return chunk(0x4d4d, chunk(0x0002, raw(3)) + chunk(0x3d3d, objects) + keyframer);
}

/// The triangle (0,0,0) (4,0,0) (0,0,4) as an object.
inline std::string triangle_3ds(const std::string& name) {
    using Three = std::array<float, 3>;
    const std::string vertices =
        raw(std::uint16_t{3}) + raw(Three{0, 0, 0}) + raw(Three{4, 0, 0}) + raw(Three{0, 0, 4});
    const std::string faces = raw(std::uint16_t{1}) + raw(std::array<std::uint16_t, 4>{0, 1, 2, 7});
    return object_3ds(name, chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces)));
}

using Keys3ds = std::vector<std::pair<std::uint32_t, std::array<float, 3>>>;

/// A track of places (0xb020) or colours (0xb025): a frame and three numbers for each key, of which
/// the first is eased.
inline std::string track_3ds(std::uint16_t id, const Keys3ds& keys) {
    std::string track = std::string(10, '\0') + raw(static_cast<std::uint32_t>(keys.size()));
    for (std::size_t k = 0; k < keys.size(); ++k) {
        track += raw(keys[k].first) + raw(std::uint16_t(k == 0 ? 0x3 : 0));
        if (k == 0) track += raw(0.5F) + raw(-0.5F);
        track += raw(keys[k].second);
    }
    return chunk(id, track);
}

/// A node of the keyframer, hung on the one with number `parent` or, -1, on none.
inline std::string node_3ds(std::uint16_t id,
                            const std::string& name,
                            std::int16_t parent,
                            const std::string& tracks) {
    const std::string header = name + '\0' + std::string(4, '\0') + raw(parent);
    return chunk(id, chunk(0xb010, header) + tracks);
}

}  // namespace ink::import
