#include "raster/mesh/lane_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/simd.h"
#include "tests/raster/triangle_pile.h"

namespace ink::raster {
namespace {

LaneTriangles set_up(const PassFormat& format, const Pile& pile) {
    const TileGrid grid{kSide_px, kSide_px, 0};
    LaneTriangles triangles;
    set_up_lanes(format, pile.source(), pile.entries, grid.drawn(0), {}, triangles);
    return triangles;
}

/// Says of every column that all rows of the box may be covered.
void forget_rows(LaneTriangles& t) {
    for (auto& rows : t.rows) {
        for (std::size_t i = 0; i < t.count; ++i)
            rows[i] = std::max(t.y1[i] - t.y0[i], 0) << 16;
    }
}

/// Rows of all columns that would be drawn.
int row_count(const LaneTriangles& t) {
    int count = 0;
    for (std::size_t i = 0; i < t.count; ++i) {
        std::size_t column = 0;
        for (int x = t.first_x[i]; x < t.x1[i]; x += LaneTriangles::kColumn_px, ++column) {
            const std::int32_t rows = t.rows[column][i];
            count += std::max((rows >> 16) - (rows & 0xffff), 0);
        }
    }
    return count;
}

TEST(LaneRows, LeaveNoPixelOut) {
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        for (const double size_px : {2.0, 6.0, 15.0, 50.0, 110.0}) {
            for (unsigned seed = 1; seed <= 20; ++seed) {
                const Pile pile(size_px, seed);
                for (const PassFormat& format : lane_test_formats()) {
                    LaneTriangles triangles = set_up(format, pile);
                    const auto drawn = drawn_words(format, triangles);
                    forget_rows(triangles);
                    EXPECT_EQ(drawn, drawn_words(format, triangles))
                        << target.name << ", " << size_px << " px, seed " << seed << ", planes "
                        << format.planes();
                }
            }
        }
    }
}

TEST(LaneRows, AreFewerThanThoseOfTheBox) {
    const core::SimdTarget target = core::current_simd_target();
    if (target.name == "SCALAR") GTEST_SKIP() << "draws all rows";
    LaneTriangles triangles = set_up(make_format(Store::none, 0), Pile(50, 1));
    const int rows = row_count(triangles);
    forget_rows(triangles);
    EXPECT_LT(rows, row_count(triangles) * 3 / 4);
    EXPECT_GT(rows, 0);
}

}  // namespace
}  // namespace ink::raster
