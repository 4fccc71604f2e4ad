#include "import/meshes/polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

namespace ink::import {
namespace {

/// One face of all points, in order.
std::vector<scene::Triangle> cut_up(const std::vector<glm::dvec3>& points) {
    Polygons faces;
    faces.corners.resize(points.size());
    std::iota(faces.corners.begin(), faces.corners.end(), 0U);
    faces.ends = {points.size()};
    return triangles_of(faces, points);
}

glm::dvec3 area_of(const scene::Triangle& t, const std::vector<glm::dvec3>& points) {
    return glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) * 0.5;
}

/// n - 2 triangles, each with an area, all turned as the face is: then they do not overlap.
void expect_covered(const std::vector<glm::dvec3>& points, const glm::dvec3& area) {
    const auto triangles = cut_up(points);
    ASSERT_EQ(triangles.size(), points.size() - 2);
    glm::dvec3 sum{0};
    for (const scene::Triangle& triangle : triangles) {
        const glm::dvec3 part = area_of(triangle, points);
        EXPECT_GT(glm::dot(part, area), 0);
        sum += part;
    }
    EXPECT_NEAR(glm::length(sum - area), 0, 1e-12);
}

TEST(Polygons, WithoutDentsAreFansFromTheFirstCorner) {
    const auto triangles = cut_up({{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {1, 3, 0}, {-1, 2, 0}});
    ASSERT_EQ(triangles.size(), 3U);
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(triangles[i], (scene::Triangle{0, i + 1, i + 2}));
}

TEST(Polygons, QuadsWithADentAreFansFromThere) {
    for (std::size_t first = 0; first < 4; ++first) {
        std::vector<glm::dvec3> points{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
        std::rotate(
            points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
        expect_covered(points, {0, 0, 4});
    }
}

TEST(Polygons, WithDentsAreCoveredOnce) {
    std::vector<glm::dvec3> star;
    for (int i = 0; i < 10; ++i) {
        const double angle = i * std::numbers::pi / 5;
        const double radius = i % 2 == 0 ? 3 : 1;
        star.emplace_back(7, radius * std::cos(angle), radius * std::sin(angle));
    }
    expect_covered(star, {10 * 0.5 * 3 * std::sin(std::numbers::pi / 5), 0, 0});
    const std::vector<glm::dvec3> comb{
        {0, 0, 0}, {0, 5, 0}, {1, 5, 0}, {1, 1, 0}, {2, 1, 0}, {2, 5, 0}, {3, 5, 0}, {3, 0, 0}};
    expect_covered(comb, {0, 0, -11});
    std::vector<glm::dvec3> turned(comb.rbegin(), comb.rend());
    expect_covered(turned, {0, 0, 11});
}

TEST(Polygons, CornersInALineGiveNoTriangleWithoutArea) {
    expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {0, 0, 4});
    expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 2});
}

TEST(Polygons, AHoleIsJoinedToItsRim) {
    const std::vector<glm::dvec3> ring{{0, 0, 0},
                                       {4, 0, 0},
                                       {4, 4, 0},
                                       {0, 4, 0},
                                       {0, 0, 0},
                                       {1, 1, 0},
                                       {1, 3, 0},
                                       {3, 3, 0},
                                       {3, 1, 0},
                                       {1, 1, 0}};
    const auto triangles = cut_up(ring);
    double area = 0;
    for (const scene::Triangle& triangle : triangles)
        area += area_of(triangle, ring).z;
    EXPECT_NEAR(area, 12, 1e-12);
}

TEST(Polygons, FewerThanThreeCornersGiveNone) {
    const Polygons faces{{0, 1, 0, 0, 1, 2}, {2, 3, 3, 6}};
    EXPECT_EQ(count_without_area(faces), 3U);
    EXPECT_EQ(triangles_of(faces, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 1U);
}

TEST(Polygons, AnythingIsCutUp) {
    std::vector<glm::dvec3> points;
    std::uint32_t state = 1;
    for (int i = 0; i < 40; ++i) {
        glm::dvec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = (state = state * 1664525 + 1013904223) >> 28;
        points.push_back(p);
        if (i < 2) continue;
        EXPECT_EQ(cut_up(points).size(), points.size() - 2);
    }
    EXPECT_EQ(cut_up(std::vector<glm::dvec3>(9, glm::dvec3(1))).size(), 7U);
}

}  // namespace
}  // namespace ink::import
