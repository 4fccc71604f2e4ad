#include "bake/flat_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "scene/scene.h"

namespace ink::bake {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct CodedMesh {
    std::vector<std::uint32_t> indices{};
    std::size_t vertex_count = 0;
    std::vector<std::uint64_t> codes{};
};

FlatCodes flat(const CodedMesh& mesh) {
    return flat_codes(mesh.indices, mesh.vertex_count, mesh.codes);
}

/// What must hold of any mesh: the same triangles, wound alike, each with its code at both ends.
void expect_law(const CodedMesh& mesh, const FlatCodes& result) {
    ASSERT_EQ(result.indices.size(), mesh.indices.size());
    ASSERT_EQ(result.source_vertex.size(), result.codes.size());
    ASSERT_GE(result.source_vertex.size(), mesh.vertex_count);
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
        ASSERT_EQ(result.source_vertex[v], v);
    for (std::size_t t = 0; t < mesh.codes.size(); ++t) {
        std::array<std::uint32_t, 3> before{};
        std::array<std::uint32_t, 3> after{};
        for (int i = 0; i < 3; ++i) {
            before[i] = mesh.indices[3 * t + i];
            ASSERT_LT(result.indices[3 * t + i], result.source_vertex.size());
            after[i] = result.source_vertex[result.indices[3 * t + i]];
        }
        bool is_rotated = false;
        for (int turn = 0; turn < 3; ++turn) {
            is_rotated |= before == after;
            std::rotate(after.begin(), after.begin() + 1, after.end());
        }
        EXPECT_TRUE(is_rotated) << "triangle " << t;
        EXPECT_EQ(result.codes[result.indices[3 * t]], mesh.codes[t]) << "triangle " << t;
        EXPECT_EQ(result.codes[result.indices[3 * t + 2]], mesh.codes[t]) << "triangle " << t;
    }
}

/// Every vertex of the result beyond the input's is a corner that some triangle needs.
void expect_no_idle_copy(const CodedMesh& mesh, const FlatCodes& result) {
    std::vector<int> ends(result.codes.size(), 0);
    for (std::size_t t = 0; t < mesh.codes.size(); ++t) {
        ++ends[result.indices[3 * t]];
        ++ends[result.indices[3 * t + 2]];
    }
    for (std::size_t v = mesh.vertex_count; v < ends.size(); ++v)
        EXPECT_GT(ends[v], 0) << "vertex " << v;
}

const std::vector<std::uint32_t> kCube = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                          1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};

TEST(FlatCodes, OneCodeChangesNothing) {
    const FlatCodes result = flat({kCube, 8, std::vector<std::uint64_t>(12, 7)});
    EXPECT_EQ(result.indices, kCube);
    EXPECT_EQ(result.added_count(8), 0U);
    EXPECT_EQ(result.codes, std::vector<std::uint64_t>(8, 7));
}

TEST(FlatCodes, ACubeOfSixCodesNeedsFourMoreVertices) {
    // 24 corners of faces; each of the 12 triangles can do without one: 12 vertices are left.
    const CodedMesh cube{kCube, 8, {1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6}};
    const FlatCodes result = flat(cube);
    expect_law(cube, result);
    EXPECT_EQ(result.added_count(8), 4U);
}

TEST(FlatCodes, TwoTrianglesOfTwoCodesShareTheirVertices) {
    const CodedMesh quad{{0, 1, 2, 0, 2, 3}, 4, {5, 9}};
    const FlatCodes result = flat(quad);
    expect_law(quad, result);
    EXPECT_EQ(result.added_count(4), 0U);
}

TEST(FlatCodes, VerticesThatNoTriangleUsesStay) {
    const FlatCodes result = flat({{3, 1, 4}, 6, {200}});
    EXPECT_THAT(result.indices, ElementsAre(3, 1, 4));
    EXPECT_THAT(result.codes, ElementsAre(0, 200, 0, 200, 200, 0));
}

TEST(FlatCodes, NothingGivesNothing) {
    EXPECT_TRUE(flat({}).source_vertex.empty());
    EXPECT_THAT(flat({{}, 2, {}}).source_vertex, ElementsAre(0, 1));
}

TEST(FlatCodes, HoldsForEveryMesh) {
    std::mt19937 random(36);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    for (int round = 0; round < 2000; ++round) {
        // Corners at random: triangles with a vertex twice or three times, fans and doubled faces.
        CodedMesh mesh{.vertex_count = 1 + below(12)};
        const std::uint32_t kinds = 1 + below(6);
        for (std::uint32_t t = below(30); t > 0; --t) {
            for (int i = 0; i < 3; ++i)
                mesh.indices.push_back(below(static_cast<std::uint32_t>(mesh.vertex_count)));
            mesh.codes.push_back((std::uint64_t{1} << 40U) * below(kinds));
        }
        const FlatCodes result = flat(mesh);
        expect_law(mesh, result);
        expect_no_idle_copy(mesh, result);
        ASSERT_FALSE(HasFailure()) << "round " << round;
        const FlatCodes again = flat(mesh);
        ASSERT_EQ(again.indices, result.indices);
        ASSERT_EQ(again.codes, result.codes);
    }
}

/// The fewest copies that any choice of corners that go without needs, all of them tried.
std::size_t fewest_copies(const CodedMesh& mesh) {
    std::size_t choices = 1, fewest = mesh.indices.size();
    for (std::size_t t = 0; t < mesh.codes.size(); ++t)
        choices *= 4;
    for (std::size_t choice = 0; choice < choices; ++choice) {
        std::set<std::pair<std::uint32_t, std::uint64_t>> needs;
        for (std::size_t t = 0; t < mesh.codes.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                if ((choice >> (2 * t) & 3U) != i)
                    needs.emplace(mesh.indices[3 * t + i], mesh.codes[t]);
        std::set<std::uint32_t> used;
        for (const auto& [vertex, code] : needs)
            used.insert(vertex);
        fewest = std::min(fewest, needs.size() - used.size());
    }
    return fewest;
}

TEST(FlatCodes, AddsHardlyMoreThanTheFewestThatWouldDo) {
    std::mt19937 random(8);
    std::size_t added = 0, fewest = 0;
    for (int round = 0; round < 60; ++round) {
        CodedMesh mesh{.vertex_count = 6};
        for (int t = 0; t < 7; ++t) {
            const auto first = static_cast<std::uint32_t>(random() % 6);
            const auto step = static_cast<std::uint32_t>(1 + random() % 2);
            for (std::uint32_t i = 0; i < 3; ++i)
                mesh.indices.push_back((first + i * step) % 6);
            mesh.codes.push_back(random() % 3);
        }
        added += flat(mesh).added_count(6);
        fewest += fewest_copies(mesh);
    }
    EXPECT_LE(static_cast<double>(added), 1.05 * static_cast<double>(fewest));
}

TEST(FlatCodes, NeedsTwoVerticesForATriangleAtMost) {
    // The worst case: a code of its own for each triangle.
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        for (const scene::Mesh& mesh : entry.make().meshes) {
            CodedMesh coded{.vertex_count = mesh.positions.size()};
            for (const scene::Triangle& t : mesh.triangles) {
                coded.indices.insert(coded.indices.end(), t.begin(), t.end());
                coded.codes.push_back(coded.codes.size());
            }
            const FlatCodes result = flat(coded);
            expect_law(coded, result);
            EXPECT_LE(result.added_count(0), coded.vertex_count + 2 * coded.codes.size() - 1)
                << entry.name;
        }
    }
}

TEST(FlatCodes, RefusesAnIndexThatIsNoVertex) {
    try {
        (void)flat({{0, 1, 3}, 3, {1}});
        FAIL();
    } catch (const core::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("vertex 3 (accepted: less than 3)"));
    }
}

}  // namespace
}  // namespace ink::bake
