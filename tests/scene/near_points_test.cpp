#include "scene/near_points.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numeric>

namespace ink::scene {
namespace {

using Points = std::vector<glm::dvec3>;

std::vector<std::uint32_t> all_of(const Points& points) {
    std::vector<std::uint32_t> part(points.size());
    std::iota(part.begin(), part.end(), 0U);
    return part;
}

Points joined(const Points& points, double distance) {
    NearPoints near(points);
    near.add(all_of(points), distance);
    return near.representatives();
}

TEST(NearPoints, JoinUpToTheDistanceAndNoFarther) {
    const Points points = {{0, 0, 0}, {0.5, 0, 0}, {2, 0, 0}, {2, 0.5, 0.25}};
    EXPECT_EQ(joined(points, 0.5), (Points{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0.5, 0.25}}));
    EXPECT_EQ(joined(points, 0.499), points);
    EXPECT_EQ(joined(points, 0), points);
    EXPECT_TRUE(joined({}, 1).empty());
}

TEST(NearPoints, PartsHaveDistancesOfTheirOwn) {
    const Points points = {{0, 0, 0}, {0.1, 0, 0}, {5, 0, 0}, {5.1, 0, 0}};
    NearPoints near(points);
    near.add(std::vector<std::uint32_t>{0, 1}, 0.2);
    near.add(std::vector<std::uint32_t>{2, 3}, 0.05);
    EXPECT_EQ(near.representatives(), (Points{{0, 0, 0}, {0, 0, 0}, {5, 0, 0}, {5.1, 0, 0}}));
}

/// Every pair, as the definition has it; the smallest position wins step by step.
Points joined_slowly(const Points& points, double distance) {
    Points result = points;
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = 0; j < points.size(); ++j) {
                if (glm::length(points[i] - points[j]) > distance || !less(result[j], result[i]))
                    continue;
                result[i] = result[j];
                is_changed = true;
            }
        }
    }
    return result;
}

TEST(NearPoints, EqualTryingEveryPair) {
    Points points;
    std::uint64_t state = 7;
    const auto next = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 40) / 16777216.0;
    };
    for (int i = 0; i < 400; ++i)
        points.push_back({next() - 0.5, next(), 0.3 * next()});
    const Points expected = joined_slowly(points, 0.04);
    EXPECT_EQ(joined(points, 0.04), expected);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        moved += expected[i] != points[i];
    EXPECT_GT(moved, 50U);
    EXPECT_LT(moved, 350U);
}

}  // namespace
}  // namespace ink::scene
