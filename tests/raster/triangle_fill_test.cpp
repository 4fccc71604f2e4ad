#include "raster/pass/tile_fill.h"

#include <gtest/gtest.h>

#include <random>

#include "core/simd.h"
#include "raster/pass/triangle_stage.h"
#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 128;

struct Case {
    PassFormat format;
    double scale;  ///< of the values
};

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const DepthFormat depth : {DepthFormat::q32, DepthFormat::z24, DepthFormat::z16}) {
        const auto add = [&](Store store, int interpolants, double scale) -> PassFormat& {
            Case made{{}, scale};
            made.format.store = store;
            made.format.interpolants = interpolants;
            made.format.depth = depth;
            made.format.halo_px = 1;
            result.push_back(made);
            return result.back().format;
        };
        add(Store::none, 0, 0);
        for (const Store store : {Store::u8, Store::u32})
            add(store, 0, 0).constant = true;
        add(Store::u8, 1, 300);  // beyond the store here and there
        add(Store::u8, 1, 200);
        add(Store::u8, 2, 300).overflow = Overflow::wrap;
        add(Store::u16, 1, 80000);
        add(Store::u16, 1, 60000).overflow = Overflow::wrap;
        add(Store::f32, 4, 1);
        add(Store::f32, 4, 1).interpolation = Interpolation::perspective;
        add(Store::u8, 1, 300).interpolation = Interpolation::perspective;
        PassFormat& wrapped = add(Store::u8, 2, 3000);
        wrapped.interpolation = Interpolation::perspective;
        wrapped.overflow = Overflow::wrap;
        add(Store::u16, 1, 80000).interpolation = Interpolation::perspective;
    }
    return result;
}

/// Triangles of all sizes, thin ones among them, some far beyond the image.
struct Input : TestMesh {
    std::vector<std::uint32_t> constants;

    explicit Input(const Case& made) {
        std::mt19937 random(7);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        for (std::uint32_t t = 0; t < 60; ++t) {
            const double reach = t % 3 == 0 ? 2000 : 150;
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                const double w = number(1, 9);
                const double y = t % 7 == 0 ? 40 + 0.02 * corner : number(-reach, reach);
                p_clip.emplace_back(number(-reach, reach) * w, y * w, w);
                for (int k = 0; k < made.format.interpolants; ++k)
                    values.push_back(static_cast<float>(number(-0.1, 1) * made.scale));
            }
            triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
            constants.push_back(1000 + t);
        }
    }
    [[nodiscard]] PassInput pass() const {
        PassInput pass = input();
        pass.constants = constants;
        return pass;
    }
};

/// The drawn planes of a tile, byte by byte.
std::vector<std::uint32_t> contents(TileBuffer& buffer, const PassFormat& format) {
    std::vector<std::uint32_t> all;
    const PixelRect& r = buffer.drawn();
    for (int y = r.y0; y < r.y1; ++y) {
        const auto add = [&](const auto* row) { all.insert(all.end(), row + r.x0, row + r.x1); };
        add(buffer.depth_row<std::uint32_t>(y));
        for (int k = 0; k < format.planes(); ++k) {
            if (format.interpolants == 0 && format.store == Store::u8) {
                add(buffer.plane_row<std::uint8_t>(k, y));
            } else {
                add(buffer.plane_row<std::uint32_t>(k, y));
            }
        }
    }
    return all;
}

TEST(TriangleFill, GivesTheBitsOfThePlainLoopOnEveryTarget) {
    const TileGrid grid{kSize_px, kSize_px, 1};
    for (const Case& made : cases()) {
        const Input scene(made);
        const PassInput input = scene.pass();
        std::vector<Batch> batches(1);
        set_up_more(made.format, input, {0, 0, kSize_px, kSize_px}, batches.front());
        const FillJob job{made.format, input, batches};
        TileBuffer plain(made.format, input, grid);
        TileBuffer vectors(made.format, input, grid);
        for (const core::SimdTarget& target : core::simd_targets()) {
            const core::ForcedSimdTarget forced(target);
            for (int tile = 0; tile < grid.count(); ++tile) {
                for (TileBuffer* buffer : {&plain, &vectors}) {
                    buffer->start(tile);
                    buffer->touch();
                }
                int drawn = 0;
                for (std::uint32_t i = 0; i < batches.front().triangles.size(); ++i) {
                    const BinEntry entry{0, i};
                    if (!fill_triangle(job, entry, vectors)) continue;
                    fill_tile(job, {&entry, 1}, plain);
                    ++drawn;
                }
                EXPECT_GT(drawn, 25);
                EXPECT_TRUE(contents(plain, made.format) == contents(vectors, made.format))
                    << target.name << " store " << static_cast<int>(made.format.store) << " tile "
                    << tile;
            }
        }
    }
}

}  // namespace
}  // namespace ink::raster
