#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

PassFormat code_format(Store store, Overflow overflow, int interpolants = 1) {
    return {.interpolants = interpolants, .store = store, .overflow = overflow};
}

/// A triangle over a whole image of `size_px` with values at (0, 0), and its slopes.
TestMesh plane_over(int size_px, double at_zero, double per_x, double per_y) {
    TestMesh mesh;
    const double far = 3.0 * size_px;
    for (const auto& [x, y] : {std::pair{-10.0, -10.0}, {far, -10.0}, {-10.0, far}}) {
        mesh.add(x, y);
        mesh.values.push_back(static_cast<float>(at_zero + per_x * x + per_y * y));
    }
    mesh.triangles.push_back({0, 1, 2});
    return mesh;
}

template <class T>
core::Image<T> draw_codes(const PassFormat& format, const TestMesh& mesh, int size_px) {
    return gathered<T>(format, mesh.input(), size_px, size_px).planes[0];
}

/// The Laplacian modulo the range of T, nearest to 0.
template <class T>
int wrapped_laplacian(const core::Image<T>& code, int x, int y) {
    const int sum = 4 * code.at(x, y) - code.at(x - 1, y) - code.at(x + 1, y) - code.at(x, y - 1) -
                    code.at(x, y + 1);
    return static_cast<std::make_signed_t<T>>(static_cast<T>(sum));
}

TEST(CodePlane, ACodeQuantisedOnceHasALaplacianOfAtMostTwoOnAnyPlaneWrappedOrNot) {
    constexpr int kSize_px = 100;
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(-1, 1);
    int largest = 0;
    for (int i = 0; i < 60; ++i) {
        const double slope = std::pow(10.0, 3 * unit(random));  // 0.001 .. 1000 codes a pixel
        const TestMesh mesh =
            plane_over(kSize_px, 300 * unit(random), slope * unit(random), slope * unit(random));
        const auto u8 =
            draw_codes<std::uint8_t>(code_format(Store::u8, Overflow::wrap), mesh, kSize_px);
        const auto u16 =
            draw_codes<std::uint16_t>(code_format(Store::u16, Overflow::wrap), mesh, kSize_px);
        for (int y = 1; y + 1 < kSize_px; ++y) {
            for (int x = 1; x + 1 < kSize_px; ++x) {
                largest = std::max({largest,
                                    std::abs(wrapped_laplacian(u8, x, y)),
                                    std::abs(wrapped_laplacian(u16, x, y))});
            }
        }
    }
    EXPECT_EQ(largest, 2) << "2 occurs, 3 must not";
}

TEST(CodePlane, TheLemmaHoldsInsideEveryTriangleOfAMesh) {
    constexpr int kSize_px = 128;
    std::mt19937 random(23);
    std::uniform_real_distribution<double> place(-20, kSize_px + 20);
    std::uniform_real_distribution<float> value(-400, 400);
    TestMesh mesh;
    for (int t = 0; t < 120; ++t) {
        // Small enough for steep slopes, each nearer than the last.
        const double x = place(random);
        const double y = place(random);
        const auto corner = [&] {
            return glm::dvec3(x + place(random) / 4, y + place(random) / 4, 99 - t / 2.0);
        };
        mesh.add_triangle(corner(), corner(), corner());
        for (int v = 0; v < 3; ++v)
            mesh.values.push_back(value(random));
    }
    const auto ids = draw_ids(mesh.input(), kSize_px, kSize_px).planes[0];
    const auto code =
        draw_codes<std::uint8_t>(code_format(Store::u8, Overflow::wrap), mesh, kSize_px);
    int stencils = 0;
    for (int y = 1; y + 1 < kSize_px; ++y) {
        for (int x = 1; x + 1 < kSize_px; ++x) {
            const std::uint32_t id = ids.at(x, y);
            const bool is_inside = id != kNobody && id == ids.at(x - 1, y) &&
                                   id == ids.at(x + 1, y) && id == ids.at(x, y - 1) &&
                                   id == ids.at(x, y + 1);
            if (!is_inside) continue;
            ++stencils;
            EXPECT_LE(std::abs(wrapped_laplacian(code, x, y)), 2) << x << " " << y;
        }
    }
    EXPECT_GT(stencils, 1000);
}

TEST(CodePlane, IsTheFloorOfTheAffineValue) {
    constexpr int kSize_px = 32;
    const TestMesh mesh = plane_over(kSize_px, 10.25, 2, 0.5);
    const auto code =
        draw_codes<std::uint8_t>(code_format(Store::u8, Overflow::saturate), mesh, kSize_px);
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x)
            EXPECT_EQ(code.at(x, y), std::floor(10.25 + 2 * (x + 0.5) + 0.5 * (y + 0.5)));
    }
}

TEST(CodePlane, SaturatesAtBothEndsOrWraps) {
    constexpr int kSize_px = 64;
    const TestMesh mesh = plane_over(kSize_px, -99.75, 8, 0);
    const auto saturated =
        draw_codes<std::uint8_t>(code_format(Store::u8, Overflow::saturate), mesh, kSize_px);
    const auto wrapped =
        draw_codes<std::uint8_t>(code_format(Store::u8, Overflow::wrap), mesh, kSize_px);
    for (int x = 0; x < kSize_px; ++x) {
        const int value = static_cast<int>(std::floor(-99.75 + 8 * (x + 0.5)));
        EXPECT_EQ(saturated.at(x, 5), std::clamp(value, 0, 255));
        EXPECT_EQ(wrapped.at(x, 5), value & 255);
    }
}

TEST(CodePlane, SixteenBitsSaturateAbove32767Too) {
    const TestMesh mesh = plane_over(8, 65530.5, 1, 0);
    const auto code =
        draw_codes<std::uint16_t>(code_format(Store::u16, Overflow::saturate), mesh, 8);
    EXPECT_EQ(code.at(0, 0), 65531);
    EXPECT_EQ(code.at(7, 0), 65535);
}

TEST(CodePlane, TheTrianglesConstantIsAdded) {
    PassFormat format = code_format(Store::u8, Overflow::wrap);
    format.constant = true;
    const TestMesh mesh = plane_over(8, 20.5, 0, 0);
    PassInput input = mesh.input();
    const std::vector<std::uint32_t> constants{250};
    input.constants = constants;
    for (const auto interpolation : {Interpolation::affine, Interpolation::perspective}) {
        format.interpolation = interpolation;
        const auto drawn = gathered<std::uint8_t>(format, input, 8, 8);
        EXPECT_EQ(drawn.planes[0].at(3, 3), (20 + 250) & 255);
    }
}

TEST(CodePlane, TwoInterpolantsFillTwoPlanes) {
    TestMesh mesh = plane_over(8, 0, 0, 0);
    mesh.values = {3.5F, 40.5F, 3.5F, 40.5F, 3.5F, 40.5F};
    const PassFormat format = code_format(Store::u8, Overflow::saturate, 2);
    const auto drawn = gathered<std::uint8_t>(format, mesh.input(), 8, 8);
    EXPECT_EQ(drawn.planes[0].at(4, 4), 3);
    EXPECT_EQ(drawn.planes[1].at(4, 4), 40);
}

TEST(CodePlane, TheLemmaHoldsWhereSnappingPutsARowJustOutsideTheUnsnappedTriangle) {
    // The upper border snaps from 10.5019 to the centres of row 10, whose values then lie 38 codes
    // beyond the corners': limiting them would bend the plane there.
    TestMesh mesh;
    mesh.add_triangle({-9, 10.5019, 1}, {99, 10.5019, 1}, {40, 60, 1});
    for (const glm::dvec3& p : mesh.p_clip)
        mesh.values.push_back(static_cast<float>(20000 * (p.y - 10.5019)));
    const auto code = draw_codes<std::uint16_t>(code_format(Store::u16, Overflow::wrap), mesh, 64);
    ASSERT_NE(code.at(40, 10), 0);
    for (int x = 10; x < 60; ++x)
        EXPECT_LE(std::abs(wrapped_laplacian(code, x, 11)), 2) << x;
}

/// A hair that snapping widens until it covers row 3 from x = 1 to 59. Unsnapped it is 0.0002 px
/// wide and row 3 lies up to twenty times that beside it.
TestMesh hair() {
    TestMesh mesh;
    mesh.add_triangle({1.5, 3.4981, 2}, {60.5, 3.5018, 2}, {59.5, 3.50196, 50});
    mesh.values = {90.5F, 90.5F, 10.5F};
    return mesh;
}

TEST(CodePlane, ASliverStaysWithinTheCodesOfItsCorners) {
    const TestMesh mesh = hair();
    for (const Overflow overflow : {Overflow::saturate, Overflow::wrap}) {
        const auto code = draw_codes<std::uint8_t>(code_format(Store::u8, overflow), mesh, 64);
        for (int x = 1; x < 59; ++x) {
            EXPECT_GE(code.at(x, 3), 10);
            EXPECT_LE(code.at(x, 3), 90);
        }
    }
}

TEST(FloatPlane, ASliverStaysWithinTheValuesOfItsCorners) {
    TestMesh mesh = hair();
    mesh.values.assign(12, 0);
    for (std::size_t corner = 0; corner < 3; ++corner)
        mesh.values[4 * corner + 2] = corner < 2 ? 0.75F : 0.25F;
    for (const auto interpolation : {Interpolation::affine, Interpolation::perspective}) {
        PassFormat format = code_format(Store::f32, Overflow::saturate, 4);
        format.interpolation = interpolation;
        const auto drawn = gathered<float>(format, mesh.input(), 64, 64);
        for (int x = 1; x < 59; ++x) {
            EXPECT_GE(drawn.planes[2].at(x, 3), 0.25F);
            EXPECT_LE(drawn.planes[2].at(x, 3), 0.75F);
        }
    }
}

TEST(Depth, OfASliverStaysWithinItsCorners) {
    const TestMesh mesh = hair();
    const auto drawn = draw_ids(mesh.input(), 64, 64);
    for (int x = 1; x < 59; ++x) {
        EXPECT_GE(drawn.depth.at(x, 3), 1 / 50.0F);
        EXPECT_LE(drawn.depth.at(x, 3), 1 / 2.0F);
    }
}

/// A quad that leaves into the distance: value 0 at its near edge (y = 0, w = 1), 1 at its far one
/// (y = 32, w = 4).
TestMesh leaving_quad() {
    TestMesh mesh;
    mesh.add(-64, 0, 1);
    mesh.add(128, 0, 1);
    mesh.add(-64, 32, 4);
    mesh.add(128, 32, 4);
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    for (int v = 0; v < 4; ++v)
        mesh.values.insert(mesh.values.end(), {v < 2 ? 0.0F : 1.0F, 7, 8, 9});
    return mesh;
}

TEST(Interpolation, AffineIsLinearOnTheScreenAndPerspectiveOnTheSurface) {
    PassFormat format = code_format(Store::f32, Overflow::saturate, 4);
    const TestMesh mesh = leaving_quad();
    const auto affine = gathered<float>(format, mesh.input(), 32, 32);
    format.interpolation = Interpolation::perspective;
    const auto perspective = gathered<float>(format, mesh.input(), 32, 32);
    for (int y = 0; y < 32; ++y) {
        const double t = (y + 0.5) / 32;
        const double on_surface = (t / 4) / ((1 - t) + t / 4);
        EXPECT_NEAR(affine.planes[0].at(16, y), t, 1e-6);
        EXPECT_NEAR(perspective.planes[0].at(16, y), on_surface, 1e-6);
        EXPECT_EQ(perspective.planes[3].at(16, y), 9) << "a constant stays exactly constant";
    }
}

TEST(Interpolation, PerspectiveCodesAreFloorsOfTheSurfaceValue) {
    TestMesh mesh = leaving_quad();
    mesh.values = {0, 0, 200, 200};
    PassFormat format = code_format(Store::u8, Overflow::saturate);
    format.interpolation = Interpolation::perspective;
    const auto code = draw_codes<std::uint8_t>(format, mesh, 32);
    for (int y = 0; y < 32; ++y) {
        const double t = (y + 0.5) / 32;
        EXPECT_EQ(code.at(9, y), std::floor(200 * (t / 4) / ((1 - t) + t / 4))) << y;
    }
}

TEST(Interpolation, AffineAfterNearClippingIsLinearFromTheCut) {
    // The far vertex row lies at w = 4, the other behind the eye; cut at w = 0.5.
    TestMesh mesh = leaving_quad();
    for (int v = 0; v < 2; ++v)
        mesh.p_clip[static_cast<std::size_t>(v)].z = -3;
    const PassFormat format = code_format(Store::f32, Overflow::saturate, 4);
    const auto drawn = gathered<float>(format, mesh.input(), 32, 64);
    // In clip space: y = 128 t, w = -3 + 7 t. Cut at t = 1/2: y_px = 128, value 1/2; ends at 32
    // px, 1.
    for (int y = 32; y < 64; ++y)
        EXPECT_NEAR(drawn.planes[0].at(16, y), 1 - 0.5 * (y + 0.5 - 32) / 96, 1e-6) << y;
}

TEST(PassInput, TrianglesSeenFromTheBackUseTheirOwnValues) {
    TestMesh mesh;
    mesh.add_triangle({0, 0, 1}, {8, 0, 1}, {0, 8, 1});
    mesh.add_triangle({8, 8, 1}, {0, 8, 1}, {8, 0, 1});
    mesh.values.assign(6, 10.5F);
    const std::vector<float> back(6, 20.5F);
    const std::vector<std::int8_t> facing{1, -1};
    PassInput input = mesh.input();
    input.values_back = back;
    input.facing = facing;
    const PassFormat format = code_format(Store::u8, Overflow::saturate);
    const auto drawn = gathered<std::uint8_t>(format, input, 8, 8);
    EXPECT_EQ(drawn.planes[0].at(0, 0), 10);
    EXPECT_EQ(drawn.planes[0].at(7, 7), 20);
}

}  // namespace
}  // namespace ink::raster
