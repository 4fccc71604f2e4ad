#include "raster/mesh/micro_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/simd.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {
namespace {

constexpr std::size_t kTriangles = 21;  // three corners each in a slot of 64; not a whole vector
constexpr int kSide_px = 64;            // one tile

PassFormat make_format(Store store, int interpolants) {
    PassFormat format;
    format.store = store;
    format.interpolants = interpolants;
    format.constant = store == Store::u32;
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

/// The tile's depth and planes as bytes.
std::vector<std::uint32_t> draw(const PassFormat& format,
                                const Pile& pile,
                                bool uses_micro_triangles) {
    const TileGrid grid{kSide_px, kSide_px, 0};
    const PassInput sky;
    TileBuffer buffer(format, sky, grid);
    buffer.start(0);
    buffer.touch();
    LaneTriangles triangles;
    set_up_lanes(format, pile.source(), pile.entries, buffer.drawn(), {}, triangles);
    if (!uses_micro_triangles)
        std::fill_n(triangles.micro_triangles.counts, LaneTriangles::kCount, -1);
    fill_lanes(format, triangles, buffer);
    std::vector<std::uint32_t> words;
    for (int y = 0; y < kSide_px; ++y) {
        const auto* depth = buffer.depth_row<std::uint32_t>(y);
        words.insert(words.end(), depth, depth + kSide_px);
        for (int k = 0; k < format.planes(); ++k) {
            const auto* plane = buffer.plane_row<std::uint32_t>(k, y);
            words.insert(words.end(), plane, plane + kSide_px);
        }
    }
    return words;
}

const std::vector<PassFormat> kFormats = {make_format(Store::none, 0),
                                          make_format(Store::u8, 1),
                                          make_format(Store::u8, 2),
                                          make_format(Store::u16, 1),
                                          make_format(Store::f32, 4),
                                          make_format(Store::u32, 0)};

TEST(MicroTriangles, AreThePixelsThatRowsDraw) {
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        for (const double size_px : {0.75, 1.5, 2.5, 4.0}) {
            for (unsigned seed = 1; seed <= 20; ++seed) {
                const Pile pile(size_px, seed);
                for (const PassFormat& format : kFormats) {
                    EXPECT_EQ(draw(format, pile, true), draw(format, pile, false))
                        << target.name << ", " << size_px << " px, seed " << seed << ", planes "
                        << format.planes();
                }
            }
        }
    }
}

TEST(MicroTriangles, SmallTrianglesAreMicroTrianglesAndLargeOnesAreNot) {
    const TileGrid grid{kSide_px, kSide_px, 0};
    const PassFormat format = make_format(Store::u8, 1);
    const auto micro_triangles_of = [&](double size_px) {
        const Pile pile(size_px, 1);
        LaneTriangles triangles;
        set_up_lanes(format, pile.source(), pile.entries, grid.drawn(0), {}, triangles);
        return std::count_if(triangles.micro_triangles.counts,
                             triangles.micro_triangles.counts + kTriangles,
                             [](std::int32_t count) { return count >= 0; });
    };
    EXPECT_EQ(micro_triangles_of(1.5), static_cast<std::ptrdiff_t>(kTriangles));
    EXPECT_LT(micro_triangles_of(40), static_cast<std::ptrdiff_t>(kTriangles / 2));
}

}  // namespace
}  // namespace ink::raster
