#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "raster/mesh/lane_triangles.h"
#include "raster/pass/tile_buffer.h"
#include "tests/raster/gather_sink.h"

namespace ink::raster {

inline constexpr std::size_t kTriangles =
    21;                              // three corners each in a slot of 64; not a whole vector
inline constexpr int kSide_px = 64;  // one tile

inline PassFormat make_format(Store store, int interpolants) {
    PassFormat format{.interpolants = interpolants, .store = store};
    format.constant = store != Store::none && interpolants == 0;
    return format;
}

/// Triangles of up to `size_px`, on top of each other in a corner of the tile and beyond it; some
/// at one depth, so that the first of them must win.
struct Pile {
    static constexpr std::size_t kArrays = 3 + kMaxPlanes;
    static constexpr std::size_t kStride = scene::kMaxClusterVertices;
    AlignedArray<std::byte> records;
    LaneSlot slot;
    std::vector<std::uint32_t> entries;

    Pile(double size_px, unsigned seed) {
        records.resize((kArrays + 2) * kStride * sizeof(float));
        std::fill_n(records.data(), records.size(), std::byte{0});
        const LaneRecords to{records.data(), kStride};
        std::minstd_rand random(seed);
        const auto number = [&](double most) {
            return most * static_cast<double>(random()) / 0x7fffffff;
        };
        auto* corners = reinterpret_cast<std::uint32_t*>(to.array(kArrays));
        for (std::uint32_t t = 0; t < kTriangles; ++t) {
            const double x = number(9) - 1;
            const double y = number(9) - 1;
            for (std::uint32_t v = 3 * t; v < 3 * t + 3; ++v) {
                to.x()[v] = static_cast<std::int32_t>((x + number(size_px)) * 65536);
                to.y()[v] = static_cast<std::int32_t>((y + number(size_px)) * 65536);
                to.q()[v] = t % 3 == 0 ? 0.5F : static_cast<float>(0.25 + number(0.5));
                for (std::size_t k = 0; k < kMaxPlanes; ++k)
                    to.array(3 + k)[v] = static_cast<float>(number(255));
            }
            corners[t] = (3 * t) | (3 * t + 1) << 8 | (3 * t + 2) << 16;
            entries.push_back(t);
        }
        slot.stride = kStride;
        auto* constants = corners + kStride;
        for (std::uint32_t t = 0; t < kTriangles; ++t)
            constants[t] = 0x80000001U + 7 * t;
        slot.corners = kArrays;
        slot.constants = (kArrays + 1) * kStride;
    }
    [[nodiscard]] LaneSource source() const { return {&slot, records.data()}; }
};

/// What fill_lanes leaves of the triangles in an empty tile: depth and planes, pixel by pixel.
inline std::vector<std::uint32_t> drawn_words(const PassFormat& format,
                                              const LaneTriangles& triangles) {
    const TileGrid grid{kSide_px, kSide_px, 0};
    const PassInput sky;
    TileBuffer buffer(format, sky, grid);
    buffer.start(0);
    buffer.touch();
    fill_lanes(format, triangles, buffer);
    buffer.finish();
    const Tile tile = buffer.view(false);
    std::vector<std::uint32_t> words;
    for (int y = 0; y < kSide_px; ++y)
        for (int x = 0; x < kSide_px; ++x)
            append_words(tile, format, x, y, words);
    return words;
}

/// One format of each kind that lanes draw.
inline std::vector<PassFormat> lane_test_formats() {
    return {make_format(Store::none, 0),
            make_format(Store::u8, 0),
            make_format(Store::u8, 1),
            make_format(Store::u8, 2),
            make_format(Store::u16, 1),
            make_format(Store::f32, 4),
            make_format(Store::u32, 0)};
}

}  // namespace ink::raster
