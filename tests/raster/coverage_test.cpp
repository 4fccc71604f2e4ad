#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr int kSize_px = 48;

/// A random coordinate that is often a pixel centre, a pixel border or exact in 1/256 px.
class Coordinates {
  public:
    explicit Coordinates(unsigned seed) : random_(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    /// Near `x`, on the grid of a random fineness.
    double near(double x, double jitter) {
        const double moved = x + uniform(-jitter, jitter);
        switch (std::uniform_int_distribution<int>(0, 3)(random_)) {
            case 0:
                return std::floor(moved) + 0.5;
            case 1:
                return std::floor(moved * 2) / 2;
            case 2:
                return std::floor(moved * 256) / 256;
            default:
                return moved;
        }
    }

  private:
    std::mt19937 random_;
};

/// A square grid of triangles with jittered vertices, all counter-clockwise, round the whole
/// image.
TestMesh jittered_grid(unsigned seed) {
    constexpr int kCells = 9;
    Coordinates coordinates(seed);
    TestMesh mesh;
    for (int j = 0; j <= kCells; ++j) {
        for (int i = 0; i <= kCells; ++i) {
            mesh.add(coordinates.near(8.0 * i - 12, 1.2),
                     coordinates.near(8.0 * j - 12, 1.2),
                     coordinates.uniform(1, 9));
        }
    }
    const auto at = [](int i, int j) { return static_cast<std::uint32_t>(j * (kCells + 1) + i); };
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            mesh.triangles.push_back({at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)});
        }
    }
    return mesh;
}

TEST(Coverage, AMeshOverTheImageCoversEveryCentreOnce) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        const TestMesh mesh = jittered_grid(seed);
        const auto count = count_coverage(mesh.input(), kSize_px, kSize_px);
        EXPECT_EQ(count, core::Image<int>(kSize_px, kSize_px, 1)) << "seed " << seed;
    }
}

/// -1, 0, 1: p outside, on the border of, inside a convex polygon of whole 1/256 px; exact.
int side_of_polygon(const std::vector<std::array<std::int64_t, 2>>& polygon,
                    std::int64_t x,
                    std::int64_t y) {
    int side = 1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        const std::int64_t e = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        if (e < 0) return -1;
        if (e == 0) side = 0;
    }
    return side;
}

TEST(Coverage, AClosedConvexFanCoversEveryCentreInsideOnceAndNoneOutside) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Coordinates coordinates(100 + seed);
        const int corners = 3 + static_cast<int>(seed % 7);
        TestMesh mesh;
        mesh.add(coordinates.near(24, 3), coordinates.near(24, 3));
        std::vector<std::array<std::int64_t, 2>> polygon;
        const double turn = coordinates.uniform(0, 2);
        for (int i = 0; i < corners; ++i) {
            const double angle = turn + i * 2 * std::numbers::pi / corners;
            const double x = std::round((24 + 20 * std::cos(angle)) * 256) / 256;
            const double y = std::round((24 + 20 * std::sin(angle)) * 256) / 256;
            mesh.add(x, y);
            polygon.push_back({std::lround(x * 256), std::lround(y * 256)});
            const auto next = static_cast<std::uint32_t>(i + 1 == corners ? 1 : i + 2);
            mesh.triangles.push_back({0, static_cast<std::uint32_t>(i + 1), next});
        }
        const auto count = count_coverage(mesh.input(), kSize_px, kSize_px);
        for (int y = 0; y < kSize_px; ++y) {
            for (int x = 0; x < kSize_px; ++x) {
                const int side = side_of_polygon(polygon, 256 * x + 128, 256 * y + 128);
                if (side == 0) continue;
                EXPECT_EQ(count.at(x, y), side > 0 ? 1 : 0) << seed << " at " << x << " " << y;
            }
        }
    }
}

/// The fan of a square round its middle, corners given.
TestMesh square_fan(double x0, double y0, double x1, double y1) {
    TestMesh mesh;
    mesh.add((x0 + x1) / 2, (y0 + y1) / 2);
    mesh.add(x0, y0);
    mesh.add(x1, y0);
    mesh.add(x1, y1);
    mesh.add(x0, y1);
    for (std::uint32_t i = 1; i <= 4; ++i)
        mesh.triangles.push_back({0, i, i % 4 + 1});
    return mesh;
}

TEST(Coverage, ASquareOnPixelCentresHasItsTopAndLeftBordersOnly) {
    // Middle, corners, borders and diagonals all run through pixel centres.
    const TestMesh mesh = square_fan(10.5, 10.5, 20.5, 20.5);
    const auto count = count_coverage(mesh.input(), kSize_px, kSize_px);
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x) {
            const bool is_inside = x >= 10 && x < 20 && y >= 10 && y < 20;
            EXPECT_EQ(count.at(x, y), is_inside ? 1 : 0) << x << " " << y;
        }
    }
}

TEST(Coverage, BothTurnsOfATriangleCoverTheSame) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> halves(0, 2 * kSize_px);
    for (int i = 0; i < 50; ++i) {
        TestMesh mesh;
        for (int v = 0; v < 3; ++v)
            mesh.add(halves(random) / 2.0, halves(random) / 2.0);
        mesh.triangles.push_back({0, 1, 2});
        const auto forward = draw_ids(mesh.input(), kSize_px, kSize_px);
        mesh.triangles[0] = {2, 1, 0};
        const auto backward = draw_ids(mesh.input(), kSize_px, kSize_px);
        EXPECT_EQ(forward.planes[0], backward.planes[0]);
    }
}

TEST(Coverage, SnapsToTheNearest256thOfAPixel) {
    // 0.5 + 1/512 - a little rounds to 0.5: the centre is on the left border, inside.
    const auto covers_first = [](double x0) {
        TestMesh mesh;
        mesh.add_triangle({x0, -10, 1}, {30, -10, 1}, {x0, 30, 1});
        return count_coverage(mesh.input(), 2, 1).at(0, 0);
    };
    EXPECT_EQ(covers_first(0.5 + 0.0019), 1);
    EXPECT_EQ(covers_first(0.5 + 0.0021), 0);
}

TEST(Coverage, TrianglesWithoutAreaCoverNothing) {
    TestMesh mesh;
    mesh.add_triangle({5.5, 5.5, 1}, {5.5, 5.5, 1}, {5.5, 5.5, 1});
    mesh.add_triangle({1.5, 1.5, 1}, {30.5, 30.5, 1}, {15.5, 15.5, 1});
    mesh.add_triangle({1.5, 7.5, 1}, {30.5, 7.5, 1}, {15.5, 7.5, 1});
    EXPECT_EQ(count_coverage(mesh.input(), kSize_px, kSize_px),
              core::Image<int>(kSize_px, kSize_px, 0));
}

}  // namespace
}  // namespace ink::raster
