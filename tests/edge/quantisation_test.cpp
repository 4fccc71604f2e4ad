// The lemmas under MOTE's filter (Inkbench design, section 6), on arithmetic alone: what quantising
// an affine value does to its five-point Laplacian.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "edge/laplacian.h"

namespace ink::edge {
namespace {

/// a x + b y + c as a 16.16 plane modulo 2^32, which steps without a rounding of its own.
struct Plane {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t c;

    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return a * static_cast<std::uint32_t>(x) + b * static_cast<std::uint32_t>(y) + c;
    }
    [[nodiscard]] int code(int x, int y) const { return static_cast<int>(at(x, y) >> 16); }
};

template <class Code>
int laplacian_at(const Code& code, int x, int y) {
    return 4 * code(x, y) - code(x, y - 1) - code(x, y + 1) - code(x - 1, y) - code(x + 1, y);
}

/// A plane whose code stays within 0..range over the 8 x 8 pixels that are looked at.
Plane random_plane(std::mt19937& random, double range) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double slope = range / 16;
    const double a = slope * (2 * unit(random) - 1);
    const double b = slope * (2 * unit(random) - 1);
    const double low = -8 * std::min(a, 0.0) - 8 * std::min(b, 0.0);
    const double high = range - 8 * std::max(a, 0.0) - 8 * std::max(b, 0.0);
    const double c = low + (high - low) * unit(random);
    const auto fixed = [](double v) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(v * 65536)));
    };
    return {fixed(a), fixed(b), fixed(c)};
}

TEST(Quantisation, OnceFromAnyAffineValueLeavesAtMostTwo) {
    std::mt19937 random(7);
    int largest = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Plane plane = random_plane(random, 252);
        const auto code = [&](int x, int y) { return plane.code(x, y); };
        for (int y = 1; y < 7; ++y) {
            for (int x = 1; x < 7; ++x)
                largest = std::max(largest, std::abs(laplacian_at(code, x, y)));
        }
    }
    EXPECT_EQ(largest, 2);
}

TEST(Quantisation, WrappingKeepsIt) {
    std::mt19937 random(8);
    std::uniform_int_distribution<std::uint32_t> bits;
    const LaplacianResponse wrapping{Response::absolute, 0, 0, 8, true};
    int wraps_met = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Plane plane{bits(random) >> 9, bits(random) >> 9, bits(random)};
        const auto code = [&](int x, int y) { return plane.code(x, y) & 255; };
        for (int x = 1; x < 7; ++x) {
            const int laplacian = laplacian_at(code, x, 3);
            wraps_met += std::abs(laplacian) > 2;
            ASSERT_LE(respond(laplacian, wrapping), 2);
        }
    }
    EXPECT_GT(wraps_met, 1000);
}

TEST(Quantisation, FourChannelsApartExceedTwoAndReachEight) {
    std::mt19937 random(9);
    int largest = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        const Plane planes[4] = {random_plane(random, 63),
                                 random_plane(random, 63),
                                 random_plane(random, 63),
                                 random_plane(random, 63)};
        const auto code = [&](int x, int y) {
            int sum = 0;
            for (const Plane& plane : planes)
                sum += plane.code(x, y);
            return sum;
        };
        for (int x = 1; x < 7; ++x)
            largest = std::max(largest, std::abs(laplacian_at(code, x, 3)));
    }
    EXPECT_GT(largest, 2);
    EXPECT_LE(largest, 8);

    // The bound is met: four equal channels, each at its own worst.
    const Plane worst{0x8000, 0x8000, 0x8000};
    const auto code = [&](int x, int y) { return worst.code(x, y); };
    int single = 0;
    for (int y = 1; y < 7; ++y) {
        for (int x = 1; x < 7; ++x)
            single = std::max(single, std::abs(laplacian_at(code, x, y)));
    }
    EXPECT_EQ(4 * single, 8);
}

TEST(Quantisation, AWrappedJumpIsMissedWithProbabilityTwoTPlusOneOverTwoToTheB) {
    constexpr int kThreshold = 3;  // misses |L| <= T
    const LaplacianResponse wrapping{Response::absolute, 0, 0, 8, true};
    std::mt19937 random(10);
    std::uniform_int_distribution<int> jump(0, 65535);
    int missed = 0;
    constexpr int kTrials = 400000;
    for (int trial = 0; trial < kTrials; ++trial) {
        // A jump of any size in a flat region, as one neighbour's difference sees it.
        missed += respond((jump(random) & 255) - 0, wrapping) <= kThreshold;
    }
    EXPECT_NEAR(missed / double{kTrials}, (2 * kThreshold + 1) / 256.0, 0.0015);
}

}  // namespace
}  // namespace ink::edge
