#include "edge/decaudin_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plain_filters.h"
#include "random_image.h"

namespace ink::edge {
namespace {

double plain_g(const core::Image<float>& image, int x, int y) {
    const double weights[3][3] = {{1, 2, 1}, {2, 0, 2}, {1, 2, 1}};
    double sum = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            sum += weights[dy + 1][dx + 1] *
                   std::abs(double{image.at(x + dx, y + dy)} - double{image.at(x, y)});
        }
    }
    return sum / 8;
}

/// By the plain filter, which decaudin() equals on every target (float_filters_simd_test.cpp).
core::Image<float> g_of(const core::Image<float>& image) {
    core::Image<float> g(image.width_px(), image.height_px());
    for (int y = 1; y + 1 < image.height_px(); ++y) {
        for (int x = 1; x + 1 < image.width_px(); ++x)
            g.at(x, y) = plain::decaudin_g_at(image.row(y) + x, image.width_px());
    }
    return g;
}

core::Image<float> p_of(const core::Image<float>& g, const DecaudinK& k) {
    core::Image<float> p(g.width_px(), g.height_px());
    for (int y = 1; y + 1 < g.height_px(); ++y) {
        decaudin_p_row(
            g.row(y - 1) + 1, g.row(y) + 1, g.row(y + 1) + 1, p.row(y) + 1, g.width_px() - 2, k);
    }
    return p;
}

TEST(Decaudin, GIsTheFormulaOnRandomImages) {
    const auto image = random_image<float>(41, 20, {-1000, 1000}, 5);
    const auto g = g_of(image);
    for (int y = 1; y < 19; ++y) {
        for (int x = 1; x < 40; ++x)
            ASSERT_NEAR(g.at(x, y), plain_g(image, x, y), 1e-3);
    }
}

TEST(Decaudin, PTakesTheSpreadOfGAndItsKEitherSideOfTheSquare) {
    // Wider than one stretch of the implementation.
    const auto g = random_image<float>(150, 20, {0, 100}, 6);
    const auto inside = p_of(g, {120, KPlace::inside});
    const auto outside = p_of(g, {9000, KPlace::outside});
    for (int y = 1; y < 19; ++y) {
        for (int x = 1; x < 149; ++x) {
            float low = g.at(x, y);
            float high = low;
            for (int i = 0; i < 9; ++i) {
                low = std::min(low, g.at(x + i % 3 - 1, y + i / 3 - 1));
                high = std::max(high, g.at(x + i % 3 - 1, y + i / 3 - 1));
            }
            const double d = high - low;
            ASSERT_NEAR(inside.at(x, y), std::min(d * d / (120.0 * 120.0), 1.0), 1e-5);
            ASSERT_NEAR(outside.at(x, y), std::min(d * d / 9000, 1.0), 1e-5);
        }
    }
}

TEST(Decaudin, AOnePixelStepIsTwoWideInGAndFourInP) {
    core::Image<float> step(14, 7, 0.0F);
    for (int y = 0; y < 7; ++y) {
        for (int x = 7; x < 14; ++x)
            step.at(x, y) = 1.0F;
    }
    const auto g = g_of(step);
    const auto p = p_of(g, {0.5F, KPlace::inside});
    for (int x = 2; x < 12; ++x) {
        EXPECT_EQ(g.at(x, 3), x == 6 || x == 7 ? 0.5F : 0.0F) << x;
        EXPECT_EQ(p.at(x, 3), x >= 5 && x <= 8 ? 1.0F : 0.0F) << x;
    }
}

TEST(Decaudin, APlaneHasOneGAndNoP) {
    core::Image<float> plane(20, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x)
            plane.at(x, y) = static_cast<float>(3 * x - 2 * y);
    }
    const auto p = p_of(g_of(plane), {0.01F, KPlace::inside});
    for (int y = 2; y < 18; ++y) {
        for (int x = 2; x < 18; ++x)
            EXPECT_EQ(p.at(x, y), 0.0F);
    }
}

}  // namespace
}  // namespace ink::edge
