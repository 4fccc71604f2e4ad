#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/simd.h"
#include "raster/fragments/cluster_fragments.h"
#include "raster/pass/screen_vertex.h"
#include "tests/raster/triangle_pile.h"

namespace ink::raster {
namespace {

/// Four tiles that meet in the pile; the image ends below and to its right, halo included or not.
const TileGrid kGrid{66, 67, 1};
constexpr int kShift_px = 60;

/// What culling would leave of a pile.
struct Culled {
    CullResult result;
    PixelRect bounds{1 << 20, 1 << 20, 0, 0};

    explicit Culled(const Pile& pile) {
        const LaneRecords records{const_cast<std::byte*>(pile.records.data()), Pile::kStride};
        const auto* corners =
            reinterpret_cast<const std::uint32_t*>(records.array(pile.slot.corners));
        for (const std::uint32_t t : pile.entries) {
            std::int32_t least[2] = {1 << 30, 1 << 30};
            std::int32_t most[2] = {0, 0};
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t vertex = corners[t] >> 8 * k & 0xff;
                const std::int32_t p[2] = {snapped(records.x()[vertex]),
                                           snapped(records.y()[vertex])};
                for (int axis = 0; axis < 2; ++axis) {
                    least[axis] = std::min(least[axis], p[axis]);
                    most[axis] = std::max(most[axis], p[axis]);
                }
            }
            bounds.x0 = std::min(bounds.x0, least[0] >> kSubpixelBits);
            bounds.y0 = std::min(bounds.y0, least[1] >> kSubpixelBits);
            bounds.x1 = std::max(bounds.x1, (most[0] >> kSubpixelBits) + 1);
            bounds.y1 = std::max(bounds.y1, (most[1] >> kSubpixelBits) + 1);
            const int x0 = first(least[0]);
            const int y0 = first(least[1]);
            const int x1 = std::min(first(most[0]), kGrid.width_px);
            const int y1 = std::min(first(most[1]), kGrid.height_px);
            if (x0 >= x1 || y0 >= y1) continue;
            result.corners[result.count] = corners[t];
            result.x_span[result.count] = x0 | x1 << 16;
            result.y_span[result.count] = y0 | y1 << 16;
            kept.push_back(t);
            ++result.count;
        }
    }
    [[nodiscard]] static std::int32_t snapped(std::int32_t fixed) { return (fixed + 128) >> 8; }
    /// The first pixel whose centre does not lie before `p`.
    [[nodiscard]] static int first(std::int32_t p) { return (p + kSubpixels / 2 - 1) >> 8; }

    std::vector<std::uint32_t> kept;
};

/// Every triangle a back one, with other values.
Pile shifted(double size_px, unsigned seed, bool is_back) {
    Pile pile(size_px, seed);
    const LaneRecords records{pile.records.data(), Pile::kStride};
    for (std::size_t v = 0; v < Pile::kStride; ++v) {
        records.x()[v] += kShift_px << kLaneBits;
        records.y()[v] += kShift_px << kLaneBits;
    }
    auto* corners = reinterpret_cast<std::uint32_t*>(records.array(pile.slot.corners));
    for (std::size_t t = 0; is_back && t < kTriangles; t += 2)
        corners[t] |= kBackSide;
    pile.slot.values[1] = 4;
    return pile;
}

/// All words of a tile, depth first.
std::vector<std::uint32_t> words_of(const PassFormat& format, TileBuffer& buffer) {
    buffer.finish();
    std::vector<std::uint32_t> words;
    const Tile tile = buffer.view(false);
    const PixelRect& drawn = buffer.drawn();
    for (int y = drawn.y0; y < drawn.y1; ++y)
        for (int x = drawn.x0; x < drawn.x1; ++x)
            append_words(tile, format, x - tile.x0_px, y - tile.y0_px, words);
    return words;
}

TileBuffer started(const PassFormat& format, const PassInput& sky, int tile) {
    TileBuffer buffer(format, sky, kGrid);
    buffer.start(tile);
    buffer.touch();
    return buffer;
}

std::vector<std::uint32_t> draw_lanes(const PassFormat& format, const Pile& pile, int tile) {
    const PassInput sky;
    TileBuffer buffer = started(format, sky, tile);
    LaneTriangles triangles;
    set_up_lanes(format, pile.source(), pile.entries, kGrid.drawn(tile), {}, triangles);
    fill_lanes(format, triangles, buffer);
    return words_of(format, buffer);
}

std::vector<std::uint32_t> draw_fragments(const PassFormat& format, const Pile& pile, int tile) {
    const PassInput sky;
    TileBuffer buffer = started(format, sky, tile);
    Culled culled(pile);
    culled.result.has_back = true;
    const LaneRecords records{const_cast<std::byte*>(pile.records.data()), Pile::kStride};
    const auto* all = reinterpret_cast<const std::uint32_t*>(records.data) + pile.slot.constants;
    alignas(64) std::uint32_t constants[CullResult::kCapacity] = {};
    for (std::size_t i = 0; i < culled.kept.size(); ++i)
        constants[i] = all[culled.kept[i]];
    const LaneDepthBias no_bias;
    ClusterFragments fragments;
    find_fragments({format,
                    no_bias,
                    records,
                    {pile.slot.values[0], pile.slot.values[1]},
                    constants,
                    culled.bounds},
                   culled.result,
                   fragments);
    AlignedArray<std::byte> block;
    block.resize(FragmentBlock::byte_count(format, fragments.count + kLanePad));
    const std::size_t count = keep_fragments(
        format, fragments, culled.bounds, {kGrid.own(tile), kGrid.drawn(tile)}, block.data());
    fill_fragments(format, FragmentBlock(block.data(), count), count, buffer);
    return words_of(format, buffer);
}

TEST(Fragments, AreThePixelsThatLanesDrawInEveryTile) {
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        for (const double size_px : {0.75, 1.5, 2.5, 4.0, 6.5}) {
            for (unsigned seed = 1; seed <= 12; ++seed) {
                const Pile pile = shifted(size_px, seed, seed % 2 == 0);
                for (PassFormat format : lane_test_formats()) {
                    if (!has_fragments(format)) continue;
                    format.halo_px = kGrid.halo_px;
                    for (int tile = 0; tile < kGrid.count(); ++tile) {
                        EXPECT_EQ(draw_fragments(format, pile, tile),
                                  draw_lanes(format, pile, tile))
                            << target.name << ", " << size_px << " px, seed " << seed << ", store "
                            << static_cast<int>(format.store) << ", tile " << tile;
                    }
                }
            }
        }
    }
}

TEST(Fragments, AreOfOnePlaneOfIntegersAtMost) {
    std::size_t with = 0;
    for (const PassFormat& format : lane_test_formats()) {
        EXPECT_EQ(has_fragments(format), format.planes() <= 1) << format.planes();
        with += has_fragments(format) ? 1 : 0;
    }
    EXPECT_EQ(with, 5U);
    PassFormat steps = make_format(Store::u8, 1);
    steps.depth = DepthFormat::z24;
    EXPECT_FALSE(has_fragments(steps));
}

}  // namespace
}  // namespace ink::raster
