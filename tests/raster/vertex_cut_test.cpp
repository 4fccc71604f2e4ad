#include "raster/pass/clip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ink::raster {
namespace {

/// Area over the plane (x, w) of triangles that lie in y = 0.
double area_xw(const CutVertices& vertices, const CutTriangles& cut) {
    double area = 0;
    for (const scene::Triangle& t : cut.triangles) {
        const glm::dvec3 u = vertices.p_clip[t[1]] - vertices.p_clip[t[0]];
        const glm::dvec3 v = vertices.p_clip[t[2]] - vertices.p_clip[t[0]];
        area += std::abs(u.x * v.z - u.z * v.x) / 2;
    }
    return area;
}

CutVertices triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return {{a, b, c}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

const std::vector<scene::Triangle> kOne = {{0, 1, 2}};
const std::vector<std::int8_t> kBack = {-1};

TEST(VertexCut, WhatLiesInsideStaysAsItIs) {
    CutVertices vertices = triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 2});
    CutTriangles cut;
    cut_triangles(kOne, kBack, 0.5, vertices, cut);
    EXPECT_EQ(vertices.p_clip.size(), 3U);
    EXPECT_EQ(cut.triangles, kOne);
    EXPECT_EQ(cut.facing, kBack);
}

TEST(VertexCut, ACornerBehindTheEyeLeavesTwoTriangles) {
    CutVertices vertices = triangle({-2, 0, 3}, {2, 0, 3}, {0, 0, -1});
    CutTriangles cut;
    cut_triangles(kOne, kBack, 1, vertices, cut);
    // Of the area 8, what lies beyond w = 1 is all but the tip of half the height.
    EXPECT_EQ(cut.triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(area_xw(vertices, cut), 6);
    ASSERT_EQ(vertices.p_clip.size(), 5U);
    EXPECT_EQ(vertices.p_clip[3].z, 1);
    EXPECT_EQ(vertices.n[3], glm::vec3(0, 0.5F, 0.5F));
}

TEST(VertexCut, CornersFarOutsideTheImageAreCutAtTheBand) {
    CutVertices vertices = triangle({-1e9, 0, 1}, {1e9, 0, 1}, {0, 0, 3});
    CutTriangles cut;
    cut_triangles(kOne, kBack, 0.1, vertices, cut);
    EXPECT_GE(cut.triangles.size(), 3U);
    for (const scene::Triangle& t : cut.triangles) {
        for (const std::uint32_t v : t) {
            const glm::dvec3& p = vertices.p_clip[v];
            EXPECT_LE(std::abs(p.x), kCutBand_px * p.z * (1 + 1e-12));
        }
    }
}

TEST(VertexCut, NeighboursCutTheirEdgeAtTheSameBits) {
    CutVertices vertices = triangle({0.1, 0.7, 3.3}, {0.9, -0.2, 2.7}, {0.3, 0.4, -0.9});
    vertices.p_clip.emplace_back(2.2, 0.1, 1.9);
    vertices.n.emplace_back(0, 0, 1);
    const std::vector<scene::Triangle> two = {{0, 1, 2}, {2, 1, 3}};
    CutTriangles cut;
    cut_triangles(two, std::vector<std::int8_t>{1, 1}, 0.5, vertices, cut);
    int equal_pairs = 0;
    for (std::size_t i = 4; i < vertices.p_clip.size(); ++i) {
        for (std::size_t j = i + 1; j < vertices.p_clip.size(); ++j) {
            equal_pairs += vertices.p_clip[i] == vertices.p_clip[j];
        }
    }
    EXPECT_EQ(equal_pairs, 1);
}

TEST(VertexCut, WhatLiesBeyondIsDropped) {
    CutVertices vertices = triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -2});
    CutTriangles cut;
    cut_triangles(kOne, kBack, 0.5, vertices, cut);
    EXPECT_TRUE(cut.triangles.empty());
    EXPECT_TRUE(cut.facing.empty());
}

}  // namespace
}  // namespace ink::raster
