#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Small Quake models made by hand: triangles of made-up vertices, as the formats lay them out.

namespace ink::import {

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void put_at(std::string& bytes, std::size_t offset, T value) {
    bytes.replace(
        offset, sizeof value, std::string(reinterpret_cast<const char*>(&value), sizeof value));
}

inline void put_name(std::string& bytes, const std::string& name, std::size_t size) {
    bytes += name + std::string(size - name.size(), '\0');
}

/// Vertices of one frame: a place in 256 steps each way and a normal's number.
using PackedFrame = std::vector<std::vector<std::uint8_t>>;

inline PackedFrame packed_frame(std::uint8_t height) {
    return {{0, 0, height, 5}, {10, 0, height, 5}, {0, 20, height, 32}};
}

/// One triangle 0, 1, 2 of steps (0.5, 0.25, 2) from (-1, 0, 3): one plain frame, and two in a
/// group where `is_grouped`, else two plain ones.
inline std::string mdl_file(bool is_grouped = false) {
    std::string bytes = "IDPO";
    put(bytes, std::int32_t{6});
    for (const float f : {0.5F, 0.25F, 2.0F, -1.0F, 0.0F, 3.0F, 100.0F, 0.0F, 0.0F, 0.0F})
        put(bytes, f);
    for (const std::int32_t count : {2, 4, 2, 3, 1, is_grouped ? 2 : 3, 0, 0})
        put(bytes, count);
    put(bytes, 1.0F);
    // A plain skin of 4 x 2, and a group of two.
    put(bytes, std::int32_t{0});
    bytes += std::string(8, 's');
    put(bytes, std::int32_t{1});
    put(bytes, std::int32_t{2});
    bytes += std::string(2 * 4 + 2 * 8, 't');
    bytes += std::string(3 * 12, '\0');
    for (const std::int32_t i : {1, 0, 1, 2})
        put(bytes, i);
    const auto put_frame = [&](std::uint8_t height) {
        bytes += std::string(8, '\0');
        put_name(bytes, "frame", 16);
        for (const auto& vertex : packed_frame(height))
            bytes.append(vertex.begin(), vertex.end());
    };
    put(bytes, std::int32_t{0});
    put_frame(0);
    if (is_grouped) {
        put(bytes, std::int32_t{1});
        put(bytes, std::int32_t{2});
        bytes += std::string(8 + 2 * 4, '\0');
        put_frame(4);
        put_frame(8);
    } else {
        put(bytes, std::int32_t{0});
        put_frame(4);
        put(bytes, std::int32_t{0});
        put_frame(8);
    }
    return bytes;
}

/// The same triangle and two frames, at heights of 0 and 4 steps.
inline std::string md2_file() {
    constexpr std::int32_t kHeader = 68;
    constexpr std::int32_t kFrame = 40 + 3 * 4;
    constexpr std::int32_t kFrames = kHeader + 12;
    constexpr std::int32_t kEnd = kFrames + 2 * kFrame + 4;
    std::string bytes = "IDP2";
    for (const std::int32_t n :
         {8, 4, 2, kFrame, 0, 3, 0, 1, 0, 2, kHeader, kHeader, kHeader, kFrames, kEnd, kEnd})
        put(bytes, n);
    for (const int i : {0, 1, 2, 0, 0, 0})
        put(bytes, static_cast<std::uint16_t>(i));
    for (const std::uint8_t height : {std::uint8_t{0}, std::uint8_t{4}}) {
        for (const float f : {0.5F, 0.25F, 2.0F, -1.0F, 0.0F, 3.0F})
            put(bytes, f);
        put_name(bytes, "frame", 16);
        for (const auto& vertex : packed_frame(height))
            bytes.append(vertex.begin(), vertex.end());
    }
    return bytes + std::string(4, '\0');
}

/// One triangle of `frames` frames, each 1 higher than the last, with a tag that stands 5 above the
/// frame's number and is turned by 90 degrees about z in every odd frame.
inline std::string md3_file(std::int32_t frames, const std::string& tag) {
    constexpr std::int32_t kHeader = 108;
    const std::int32_t tags = kHeader;
    const std::int32_t surface = tags + frames * 112;
    const std::int32_t surface_bytes = 108 + 12 + 3 * 8 * frames;
    std::string bytes = "IDP3";
    put(bytes, std::int32_t{15});
    put_name(bytes, "model", 64);
    for (const std::int32_t n :
         {0, frames, 1, 1, 0, kHeader, tags, surface, surface + surface_bytes})
        put(bytes, n);
    for (std::int32_t f = 0; f < frames; ++f) {
        put_name(bytes, tag, 64);
        const float turn = f % 2 == 1 ? 1.0F : 0.0F;
        for (const float v : {0.0F, 0.0F, 5.0F + static_cast<float>(f)})
            put(bytes, v);
        for (const float v : {1 - turn, turn, 0.0F, -turn, 1 - turn, 0.0F, 0.0F, 0.0F, 1.0F})
            put(bytes, v);
    }
    bytes += "IDP3";
    put_name(bytes, "skin", 64);
    for (const std::int32_t n : {0, frames, 0, 3, 1, 108, 120, 120, 120, surface_bytes})
        put(bytes, n);
    for (const std::int32_t i : {0, 1, 2})
        put(bytes, i);
    for (std::int32_t f = 0; f < frames; ++f) {
        for (const int corner : {0, 1, 2}) {
            put(bytes, static_cast<std::int16_t>(corner == 1 ? 64 : 0));
            put(bytes, static_cast<std::int16_t>(corner == 2 ? 128 : 0));
            put(bytes, static_cast<std::int16_t>(64 * f));
            put(bytes, std::uint16_t{0});
        }
    }
    return bytes;
}

}  // namespace ink::import
