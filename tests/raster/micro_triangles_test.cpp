#include "raster/mesh/micro_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/simd.h"
#include "tests/raster/triangle_pile.h"

namespace ink::raster {
namespace {

std::vector<std::uint32_t> draw(const PassFormat& format,
                                const Pile& pile,
                                bool uses_micro_triangles) {
    const TileGrid grid{kSide_px, kSide_px, 0};
    LaneTriangles triangles;
    set_up_lanes(format, pile.source(), pile.entries, grid.drawn(0), {}, triangles);
    if (!uses_micro_triangles)
        std::fill_n(triangles.micro_triangles.counts, LaneTriangles::kCount, -1);
    return drawn_words(format, triangles);
}

TEST(MicroTriangles, AreThePixelsThatRowsDraw) {
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        for (const double size_px : {0.75, 1.5, 2.5, 4.0}) {
            for (unsigned seed = 1; seed <= 20; ++seed) {
                const Pile pile(size_px, seed);
                for (const PassFormat& format : lane_test_formats()) {
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
