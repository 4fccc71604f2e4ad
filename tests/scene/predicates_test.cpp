#include "scene/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scene/whole_orient3d.h"

namespace ink::scene {
namespace {

TEST(Orient3d, IsNegativeInFrontOfACounterClockwiseFace) {
    const glm::dvec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    EXPECT_EQ(orient3d(a, b, c, {0.2, 0.2, 1}), -1);
    EXPECT_EQ(orient3d(a, b, c, {0.2, 0.2, -1}), 1);
    EXPECT_EQ(orient3d(a, b, c, {7, -3, 0}), 0);
    EXPECT_EQ(facing(a, b, c, {0.2, 0.2, 1}), 1);
}

// Points within a few units of one plane, with coordinates near 2^29: the determinant needs about
// 90 bits, so double guesses. The set is only worth something if double does go wrong on it.
TEST(Orient3d, IsExactWherePlainDoubleHasTheWrongSign) {
    std::mt19937_64 random(7);
    std::uniform_int_distribution<int> wide(-(1 << 29), 1 << 29);
    std::uniform_int_distribution<int> few(-1, 1);
    int wrong_in_double = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto in_plane = [&] {  // x + y + z = 0, then nudged
            const double x = wide(random), y = wide(random);
            return glm::dvec3(x, y, -x - y + few(random));
        };
        const glm::dvec3 a = in_plane(), b = in_plane(), c = in_plane(), d = in_plane();
        const int truth = integer_orient3d(a, b, c, d);
        ASSERT_EQ(orient3d(a, b, c, d), truth);
        wrong_in_double += plain_double_orient3d(a, b, c, d) != truth;
    }
    EXPECT_GT(wrong_in_double, 100);
}

// From a point of the plane, one step against the direction: all whole numbers, so exact.
TEST(Orient3d, OfADirectionIsThatOfAStepAgainstIt) {
    std::mt19937_64 random(23);
    std::uniform_int_distribution<int> wide(-(1 << 28), 1 << 28);
    std::uniform_int_distribution<int> few(-1, 1);
    int in_plane = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto point = [&] {
            const double x = wide(random), y = wide(random);
            return glm::dvec3(x, y, -x - y);
        };
        const glm::dvec3 a = point(), b = point(), c = point();
        const glm::dvec3 way = point() + glm::dvec3(0, 0, few(random));
        const int side = orient3d(a, b, c, Viewpoint{way, true});
        ASSERT_EQ(side, integer_orient3d(a, b, c, a - way));
        in_plane += side == 0 ? 1 : 0;
    }
    EXPECT_GT(in_plane, 5000);
    EXPECT_LT(in_plane, 9000);
}

TEST(Orient3d, ChangesSignUnderEverySwapNearCoplanarity) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 a{unit(random), unit(random), unit(random)};
        const glm::dvec3 b{unit(random), unit(random), unit(random)};
        const glm::dvec3 c{unit(random), unit(random), unit(random)};
        const double s = unit(random), t = unit(random);
        const glm::dvec3 d = a + s * (b - a) + t * (c - a);  // coplanar up to rounding
        const int sign = orient3d(a, b, c, d);
        EXPECT_EQ(orient3d(b, a, c, d), -sign);
        EXPECT_EQ(orient3d(a, c, b, d), -sign);
        EXPECT_EQ(orient3d(b, c, a, d), sign);
        EXPECT_EQ(orient3d(d, b, c, a), -sign);
    }
}

TEST(Collinear, TellsALineFromAnUlpBesideIt) {
    const glm::dvec3 a{0.1, 0.2, 0.3};
    const glm::dvec3 c{0.30000000000000004, 0.6, 0.8999999999999999};
    EXPECT_TRUE(is_collinear({1, 2, 3}, {2, 4, 6}, {4, 8, 12}));
    EXPECT_TRUE(is_collinear(a, a, c));
    EXPECT_FALSE(is_collinear({1, 2, 3}, {2, 4, 6}, {4, 8, std::nextafter(12.0, 13.0)}));
}

}  // namespace
}  // namespace ink::scene
