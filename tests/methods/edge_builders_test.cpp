#include "methods/edge_list/edge_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "buffers/vertex_weld.h"
#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "scene/surface.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {
namespace {

constexpr std::array kBuilders{EdgeBuilder::all_pairs, EdgeBuilder::temp_list, EdgeBuilder::hash};

std::vector<scene::Triangle> welded(const std::vector<glm::dvec3>& points,
                                    const std::vector<scene::Triangle>& triangles) {
    return buffers::weld_faces(
               buffers::weld_vertices(points, 0), points, triangles, buffers::DoubleFaces::keep)
        .faces;
}

std::vector<scene::Triangle> welded(const scene::Mesh& mesh) {
    return welded({mesh.positions.begin(), mesh.positions.end()}, mesh.triangles);
}

/// The catalogue's rocket as one list of 100 triangles.
std::vector<scene::Triangle> rocket() {
    const scene::Surface surface = scene::flatten(catalogue::make_catalogue_scene("rocket"));
    return welded(surface.p_world, surface.triangles);
}

std::vector<ListedEdge> sorted(std::vector<ListedEdge> edges) {
    std::sort(edges.begin(), edges.end(), [](const ListedEdge& x, const ListedEdge& y) {
        return std::tie(x.a, x.b, x.faces) < std::tie(y.a, y.b, y.faces);
    });
    return edges;
}

/// All builders on these triangles: they agree, and each edge is a side of its faces.
std::vector<ListedEdge> edges_by_all(const std::vector<scene::Triangle>& triangles) {
    const auto edges = sorted(list_edges(triangles, EdgeBuilder::all_pairs).edges);
    for (const EdgeBuilder builder : kBuilders) {
        const EdgeListing listing = list_edges(triangles, builder);
        EXPECT_EQ(sorted(listing.edges), edges);
        EXPECT_EQ(listing.counts.lookups, triangles.size() * 3);
    }
    for (const ListedEdge& edge : edges) {
        EXPECT_LT(edge.a, edge.b);
        for (const std::uint32_t face : edge.faces) {
            if (face == kNoFace) continue;
            const auto& corners = triangles[face];
            EXPECT_EQ(std::count(corners.begin(), corners.end(), edge.a), 1);
            EXPECT_EQ(std::count(corners.begin(), corners.end(), edge.b), 1);
        }
    }
    return edges;
}

std::size_t count_boundary(const std::vector<ListedEdge>& edges) {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.is_boundary(); }));
}

void expect_closed(const std::vector<scene::Triangle>& triangles, std::size_t edge_count) {
    const auto edges = edges_by_all(triangles);
    EXPECT_EQ(edges.size(), edge_count);
    EXPECT_EQ(count_boundary(edges), 0U);
}

TEST(EdgeBuilders, AllThreeGiveTheEdgesOfClosedForms) {
    expect_closed({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, 6);  // tetrahedron
    expect_closed(welded(scene::unit_cube()), 12 + 6);               // and a diagonal a side
    expect_closed(welded(catalogue::make_icosphere(1, 0)), 30);
    expect_closed(welded(catalogue::make_icosphere(1, 3)), 30 * 64);
    expect_closed(welded(catalogue::make_torus({2, 0.5}, {12, 7})), 3 * 12 * 7);
    expect_closed(rocket(), 150);
}

TEST(EdgeBuilders, AllThreeAgreeOnWhatIsNotClosed) {
    const auto sheet = catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 2});
    const auto edges = edges_by_all(welded(sheet));
    EXPECT_EQ(edges.size(), 4 * 2 + 3 * 3 + 6U);  // across, along, diagonals
    EXPECT_EQ(count_boundary(edges), 10U);
    EXPECT_TRUE(edges_by_all({}).empty());
}

TEST(EdgeBuilders, OfThreeFacesTheFirstTwoAreAnEdgeAndTheThirdIsABoundary) {
    const auto edges = edges_by_all({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    EXPECT_EQ(edges.size(), 8U);  // six sides apart from the shared edge, which is there twice
    EXPECT_EQ(edges[0], (ListedEdge{0, 1, {0, 1}}));
    EXPECT_EQ(edges[1], (ListedEdge{0, 1, {2, kNoFace}}));
    const auto four = edges_by_all({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}});
    EXPECT_EQ(four[1], (ListedEdge{0, 1, {2, 3}}));
    EXPECT_EQ(count_boundary(four), 8U);
}

TEST(EdgeBuilders, AllPairsComparesEveryTwoSidesOnce) {
    const BuildCounts counts = list_edges(rocket(), EdgeBuilder::all_pairs).counts;
    EXPECT_EQ(counts.comparisons, 300U * 299 / 2);
    EXPECT_EQ(counts.comparisons_per_lookup(), 149.5);
}

/// What CoRgi's list must compare, from the edges alone: a side meets those that wait and came
/// after its mate, and the mate; without a mate all that wait.
std::uint64_t comparisons_from_mates(const std::vector<scene::Triangle>& triangles) {
    const std::size_t sides = triangles.size() * 3;
    const auto ends = [&](std::size_t side) {
        const auto& t = triangles[side / 3];
        return std::minmax({t[side % 3], t[(side % 3 + 1) % 3]});
    };
    std::vector<std::size_t> mate(sides, sides);
    for (std::size_t i = 0; i < sides; ++i) {
        for (std::size_t j = 0; j < sides; ++j) {
            if (i != j && ends(i) == ends(j)) mate[i] = j;  // closed: there is one
        }
    }
    std::uint64_t comparisons = 0;
    for (std::size_t s = 0; s < sides; ++s) {
        const std::size_t from = mate[s] < s ? mate[s] : 0;
        for (std::size_t waits = from; waits < s; ++waits)
            comparisons += mate[waits] >= s ? 1 : 0;
    }
    return comparisons;
}

TEST(EdgeBuilders, TempListComparesWithThoseThatWaitOnly) {
    for (const auto& triangles : {rocket(), welded(catalogue::make_icosphere(1, 2))}) {
        const BuildCounts counts = list_edges(triangles, EdgeBuilder::temp_list).counts;
        EXPECT_EQ(counts.comparisons, comparisons_from_mates(triangles));
    }
}

/// The edges found so far when each side is looked up: without a list of those that wait, what it
/// goes through.
std::uint64_t longest_list_of_edges(const std::vector<scene::Triangle>& triangles) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const scene::Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            edges.insert(std::minmax({t[i], t[(i + 1) % 3]}));
    return edges.size();
}

/// CoRgi's page says at most about 150 comparisons, and at most 32 with its list.
TEST(EdgeBuilders, ListsOfTheRocketAreSoLongAtMost) {
    auto triangles = rocket();
    EXPECT_EQ(longest_list_of_edges(triangles), 150U);
    const BuildCounts in_order = list_edges(triangles, EdgeBuilder::temp_list).counts;
    EXPECT_EQ(in_order.longest, 11U);
    EXPECT_NEAR(in_order.comparisons_per_lookup(), 5.7, 0.05);
    const BuildCounts hashed = list_edges(triangles, EdgeBuilder::hash).counts;
    EXPECT_EQ(hashed.longest, 11U);
    EXPECT_NEAR(hashed.comparisons_per_lookup(), 0.6, 0.05);

    std::mt19937 random(7);
    double mean = 0;
    double longest = 0;
    constexpr int kOrders = 200;
    for (int i = 0; i < kOrders; ++i) {
        for (std::size_t t = triangles.size() - 1; t > 0; --t)
            std::swap(triangles[t], triangles[random() % (t + 1)]);
        const BuildCounts counts = list_edges(triangles, EdgeBuilder::temp_list).counts;
        mean += counts.comparisons_per_lookup() / kOrders;
        longest += static_cast<double>(counts.longest) / kOrders;
    }
    EXPECT_NEAR(longest, 80, 1);
    // A side waits with chance p, the share of triangles seen, and its mate has not come with
    // 1 - p: 300 p (1 - p) wait, half of them are passed before the mate, all if it has not come.
    // The mean over p of 300 p (1 - p) (1 - p / 2) is 37.5.
    EXPECT_NEAR(mean, 37.5, 2);
}

}  // namespace
}  // namespace ink::methods
