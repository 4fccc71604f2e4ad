#include "edge/decaudin_filter.h"

#include <gtest/gtest.h>

#include "plain_filters.h"

namespace ink::edge {
namespace {

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

}  // namespace
}  // namespace ink::edge
