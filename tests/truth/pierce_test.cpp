#include "truth/crossings/pierce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/predicates.h"
#include "tests/scene/whole_orient3d.h"
#include "tests/truth/shapes.h"
#include "truth/crossings/crossings.h"

namespace ink::truth {
namespace {

/// One object of loose triangles; weld joins their common corners.
scene::Topology welded(const std::vector<std::array<glm::vec3, 3>>& triangles) {
    scene::Mesh mesh;
    for (const auto& [a, b, c] : triangles)
        add_triangle(mesh, a, b, c);
    return scene::weld(scene_of({mesh}));
}

void expect_segment(const Meeting& meeting, const glm::dvec3& a, const glm::dvec3& b) {
    ASSERT_TRUE(meeting.crossing.has_value());
    EXPECT_EQ(meeting.contact_count, 0U);
    EXPECT_FALSE(meeting.is_coplanar);
    glm::dvec3 begin = meeting.crossing->begin_world, end = meeting.crossing->end_world;
    if (glm::length(begin - a) > glm::length(end - a)) std::swap(begin, end);
    EXPECT_LE(glm::length(begin - a), meeting.crossing->error + 1e-300);
    EXPECT_LE(glm::length(end - b), meeting.crossing->error + 1e-300);
    EXPECT_LT(meeting.crossing->error, 1e-10);
}

void expect_nothing(const Meeting& meeting) {
    EXPECT_FALSE(meeting.crossing.has_value());
    EXPECT_EQ(meeting.contact_count, 0U);
    EXPECT_FALSE(meeting.is_coplanar);
}

/// The stretch of the edge between two points, from the lower to the higher end of x.
void expect_contact(const scene::Topology& topology,
                    const Contact& contact,
                    const glm::dvec3& from,
                    const glm::dvec3& to) {
    const scene::Edge& edge = topology.edges[contact.edge];
    const glm::dvec3 a = topology.p_world[edge.a], b = topology.p_world[edge.b];
    glm::dvec3 begin = a + contact.t_begin * (b - a), end = a + contact.t_end * (b - a);
    if (glm::length(begin - from) > glm::length(end - from)) std::swap(begin, end);
    EXPECT_LT(glm::length(begin - from), 1e-12);
    EXPECT_LT(glm::length(end - to), 1e-12);
}

constexpr glm::vec3 kP{2, -2, 0}, kQ{2, 2, 0}, kR{-2, 0, 0};  ///< y = 0 in it from x = -2 to 2

TEST(Pierce, BladeThroughATriangle) {
    // At z = 0 the blade is a quarter of its foot wide on either side.
    const auto topology =
        welded({{kP, kQ, kR}, {glm::vec3{0, -0.5F, -1}, {0, 0.5F, -1}, {0, 0, 1}}});
    expect_segment(meet(topology, 0, 1), {0, -0.25, 0}, {0, 0.25, 0});
    expect_segment(meet(topology, 1, 0), {0, -0.25, 0}, {0, 0.25, 0});
    EXPECT_EQ(meet(topology, 1, 0).crossing->face0, 0U);
    EXPECT_EQ(meet(topology, 1, 0).crossing->face1, 1U);
}

TEST(Pierce, SegmentEndsWhereTheFirstOfBothEnds) {
    // Along y = 0 the blade runs from x = -1 to 5, the triangle from -2 to 2.
    const auto topology =
        welded({{kP, kQ, kR}, {glm::vec3{-1, 0, 0.5F}, {-1, 0, -0.5F}, {5, 0, 0}}});
    expect_segment(meet(topology, 0, 1), {-1, 0, 0}, {2, 0, 0});
}

TEST(Pierce, SharedVertexAndACrossing) {
    const glm::vec3 shared{0, 0, 0};
    const auto topology =
        welded({{shared, {2, -1, 0}, {2, 1, 0}}, {shared, {4, 0, -1}, {4, 0, 1}}});
    ASSERT_EQ(topology.p_world.size(), 5U);
    expect_segment(meet(topology, 0, 1), {0, 0, 0}, {2, 0, 0});
}

TEST(Pierce, SharedVertexAndNoCrossing) {
    const glm::vec3 shared{0, 0, 0};
    const auto topology = welded({{shared, {2, -1, 0}, {2, 1, 0}},
                                  {shared, {-4, 0, -1}, {-4, 0, 1}},
                                  {shared, {4, 0, 1}, {4, 0, 3}}});
    expect_nothing(meet(topology, 0, 1));
    expect_nothing(meet(topology, 0, 2));
}

TEST(Pierce, PointsAndSharedEdgesAreNothing) {
    const auto topology = welded({{kP, kQ, kR},
                                  {glm::vec3{0, 0, 0}, {0, 1, 2}, {1, 0, 2}},      // tip inside
                                  {glm::vec3{2, 0, -1}, {2, 0, 1}, {3, 0, 0}},     // edge on edge
                                  {glm::vec3{-2, 0, -1}, {-2, 0, 1}, {-3, 0, 0}},  // edge on tip
                                  {kP, kQ, {2, 0, 3}}});                           // neighbours
    for (std::uint32_t g = 1; g <= 4; ++g) {
        SCOPED_TRACE(g);
        expect_nothing(meet(topology, 0, g));
    }
}

TEST(Pierce, FootOnATriangleIsAContactOfItsEdge) {
    const auto topology = welded({{kP, kQ, kR}, {glm::vec3{0, 0, 0}, {4, 0, 0}, {2, 0, 2}}});
    const Meeting meeting = meet(topology, 0, 1);
    EXPECT_FALSE(meeting.crossing.has_value());
    ASSERT_EQ(meeting.contact_count, 1U);
    EXPECT_EQ(meeting.contacts[0].face, 0U);
    expect_contact(topology, meeting.contacts[0], {0, 0, 0}, {2, 0, 0});
}

TEST(Pierce, CollinearEdgesAreContactsOfBoth) {
    // A wall that stands on the rim x = 2 of the triangle and sticks out beyond its end.
    const auto topology = welded({{kP, kQ, kR}, {glm::vec3{2, 1, 0}, {2, 4, 0}, {2, 2, 2}}});
    const Meeting meeting = meet(topology, 0, 1);
    EXPECT_FALSE(meeting.crossing.has_value());
    ASSERT_EQ(meeting.contact_count, 2U);
    for (std::size_t i = 0; i < 2; ++i)
        expect_contact(topology, meeting.contacts[i], {2, 1, 0}, {2, 2, 0});
    EXPECT_NE(meeting.contacts[0].face, meeting.contacts[1].face);
}

TEST(Pierce, CoplanarTrianglesTouchAlongTheirSidesWithinEachOther) {
    const auto topology = welded(
        {{glm::vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {glm::vec3{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}});
    const Meeting meeting = meet(topology, 0, 1);
    EXPECT_TRUE(meeting.is_coplanar);
    EXPECT_FALSE(meeting.crossing.has_value());
    ASSERT_EQ(meeting.contact_count, 3U);
    expect_contact(topology, meeting.contacts[0], {3, 1, 0}, {1, 3, 0});
    expect_contact(topology, meeting.contacts[1], {1, 1, 0}, {3, 1, 0});
    expect_contact(topology, meeting.contacts[2], {1, 1, 0}, {1, 3, 0});
}

TEST(Pierce, CoplanarNeighboursAndTouchingTipsAreNothing) {
    const auto topology = welded({{glm::vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                  {glm::vec3{4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                                  {glm::vec3{2, 2, 0}, {3, 4, 0}, {4, 3, 0}},
                                  {glm::vec3{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}}});
    expect_nothing(meet(topology, 0, 1));
    expect_nothing(meet(topology, 0, 2));
    expect_nothing(meet(topology, 0, 3));
}

TEST(Pierce, FaceFoldedFlatOnItsNeighbourIsCoplanar) {
    const auto topology = welded(
        {{glm::vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {glm::vec3{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}});
    const Meeting meeting = meet(topology, 0, 1);
    EXPECT_TRUE(meeting.is_coplanar);
    EXPECT_EQ(meeting.contact_count, 2U) << "both loose sides of the small one";
    const Crossings found = find_crossings(topology, {});
    EXPECT_EQ(found.contacts.size(), 2U);
    ASSERT_EQ(found.coplanar_with(1).size(), 1U);
    EXPECT_EQ(found.coplanar_with(1)[0].lower_face, 0U);
}

/// By definition, and no other way: does a side of one triangle pass through the inside of the
/// other? 0 no, 1 yes, -1 in no general position.
template <class Orient>
int crosses_by_sides(const std::array<glm::dvec3, 6>& p, Orient orient) {
    bool is_crossing = false;
    for (const std::size_t f : {0U, 3U}) {
        const std::size_t g = 3 - f;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 &r = p[g + i], &s = p[g + (i + 1) % 3];
            const int at_r = orient(p[f], p[f + 1], p[f + 2], r);
            const int at_s = orient(p[f], p[f + 1], p[f + 2], s);
            int sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const int turn = orient(r, s, p[f + k], p[f + (k + 1) % 3]);
                if (turn == 0) return -1;
                sum += turn;
            }
            if (at_r == 0 || at_s == 0) return -1;
            is_crossing = is_crossing || (at_r != at_s && std::abs(sum) == 3);
        }
    }
    return is_crossing ? 1 : 0;
}

scene::Topology two_triangles(const std::array<glm::dvec3, 6>& p) {
    scene::Topology topology;
    topology.p_world.assign(p.begin(), p.end());
    topology.rounding_world.assign(p.size(), 0);
    for (std::uint32_t f = 0; f < 2; ++f) {
        scene::Face face;
        for (std::uint32_t i = 0; i < 3; ++i) {
            face.vertices[i] = 3 * f + i;
            face.edges[i] = 3 * f + i;
            topology.edges.push_back(
                {3 * f + std::min(i, (i + 1) % 3), 3 * f + std::max(i, (i + 1) % 3), 3 * f + i, 1});
            topology.edge_faces.push_back(f);
        }
        topology.faces.push_back(face);
    }
    return topology;
}

// A blade that comes in over the side y = x of a triangle and whose upright edge stands at
// (1/2 + i ulp, 1/2 + j ulp): it reaches inside if j < i (Kettner et al. 2008, "Classroom examples
// of robustness problems in geometric computations", section 3).
TEST(Pierce, IsExactWherePlainDoubleErrs) {
    constexpr double kUlp = 1.0 / (1ULL << 53);
    int wrong_in_double = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const double x = 0.5 + i * kUlp, y = 0.5 + j * kUlp;
            const std::array<glm::dvec3, 6> p = {glm::dvec3(-24, -24, 0),
                                                 {24, -24, 0},
                                                 {24, 24, 0},
                                                 {x, y, -1},
                                                 {x, y, 1},
                                                 {-20, 20, 0.25}};
            const scene::Topology topology = two_triangles(p);
            ASSERT_EQ(meet(topology, 0, 1).crossing.has_value(), j < i) << i << " " << j;
            ASSERT_EQ(find_crossings(topology, {}).segments.size(), j < i ? 1U : 0U);
            if (i != j)
                wrong_in_double += crosses_by_sides(p, scene::plain_double_orient3d) != (j < i);
        }
    }
    EXPECT_GT(wrong_in_double, 100);
}

TEST(Pierce, AgreesWithIntegersOnNearlyCoplanarPairs) {
    Noise noise(11);
    const auto wide = [&] { return std::floor((2 * noise.next() - 1) * (1 << 29)); };
    const auto in_plane = [&] {
        const double x = wide(), y = wide();
        return glm::dvec3(x, y, -x - y + std::floor(3 * noise.next()) - 1);
    };
    int crossings = 0, decided = 0;
    for (int i = 0; i < 20000; ++i) {
        std::array<glm::dvec3, 6> p;
        for (glm::dvec3& corner : p)
            corner = in_plane();
        const int truth = crosses_by_sides(p, scene::integer_orient3d);
        if (truth < 0) continue;
        ++decided;
        crossings += truth;
        const scene::Topology topology = two_triangles(p);
        ASSERT_EQ(meet(topology, 0, 1).crossing.has_value(), truth == 1);
        ASSERT_EQ(find_crossings(topology, {}).segments.size(), static_cast<std::size_t>(truth));
    }
    EXPECT_GT(decided, 10000);
    EXPECT_GT(crossings, 1000);
}

/// Triangles of all sizes; on a coarse grid nearly everything touches, folds and coincides.
scene::Topology soup(std::uint64_t seed, int count, float grid) {
    Noise noise(seed);
    const auto coordinate = [&](double size) {
        const auto x = static_cast<float>(size * (2 * noise.next() - 1));
        return grid > 0 ? std::round(x / grid) * grid : x;
    };
    const auto point = [&](double size) {
        const float x = coordinate(size), y = coordinate(size);
        return glm::vec3(x, y, coordinate(size));
    };
    scene::Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = point(2);
        const double size = 0.2 + 1.5 * noise.next();
        const glm::vec3 b = a + point(size), c = a + point(size);
        add_triangle(mesh, a, b, c);
        if (i % 3 == 0) add_triangle(mesh, c, b, a + point(size));
        if (i % 4 == 0) add_triangle(mesh, a, a + point(size), a + point(size));
    }
    return scene::weld(scene_of({mesh}));
}

std::vector<std::array<double, 5>> comparable(const Crossings& found) {
    std::vector<std::array<double, 5>> all;
    for (const Crossing& c : found.segments)
        all.push_back({0, 1.0 * c.face0, 1.0 * c.face1, c.begin_world.x, c.end_world.x});
    for (const Contact& c : found.contacts)
        all.push_back({1, 1.0 * c.edge, 1.0 * c.face, 0, 0});
    for (const CoplanarPair& c : found.coplanar)
        all.push_back({2, 1.0 * c.face, 1.0 * c.lower_face, 0, 0});
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

Crossings by_all_pairs(const scene::Topology& topology) {
    Crossings found;
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        for (std::uint32_t g = f + 1; g < topology.faces.size(); ++g) {
            const Meeting meeting = meet(topology, f, g);
            if (meeting.crossing) found.segments.push_back(*meeting.crossing);
            for (std::size_t i = 0; i < meeting.contact_count; ++i)
                found.contacts.push_back(meeting.contacts[i]);
            if (meeting.is_coplanar) found.coplanar.push_back({g, f});
        }
    }
    return found;
}

TEST(Crossings, TreeFindsWhatTryingAllPairsFinds) {
    for (const float grid : {0.0F, 0.25F, 1.0F}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            SCOPED_TRACE(testing::Message() << "grid " << grid << " seed " << seed);
            const scene::Topology topology = soup(seed, 150, grid);
            const Crossings found = find_crossings(topology, {});
            EXPECT_EQ(comparable(found), comparable(by_all_pairs(topology)));
            EXPECT_GT(found.segments.size(), 20U);
            EXPECT_GE(found.contacts.size(), grid == 1 ? 50U : grid > 0 ? 5U : 0U);
            EXPECT_GE(found.coplanar.size(), grid == 1 ? 10U : 0U);
        }
    }
}

TEST(Crossings, AgreeWithTheDefinitionInGeneralPosition) {
    const scene::Topology topology = soup(5, 120, 0);
    const auto exact = [](const auto&... corners) { return scene::orient3d(corners...); };
    std::size_t expected = 0, undecided = 0;
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        for (std::size_t g = f + 1; g < topology.faces.size(); ++g) {
            std::array<glm::dvec3, 6> p;
            for (std::size_t i = 0; i < 3; ++i) {
                p[i] = topology.p_world[topology.faces[f].vertices[i]];
                p[3 + i] = topology.p_world[topology.faces[g].vertices[i]];
            }
            const int crosses = crosses_by_sides(p, exact);
            expected += crosses == 1 ? 1 : 0;
            undecided += crosses < 0 ? 1 : 0;
        }
    }
    // Undecided are pairs that share a corner; they are in the count of the tree only if they
    // cross.
    const std::size_t found = find_crossings(topology, {}).segments.size();
    EXPECT_GE(found, expected);
    EXPECT_LE(found, expected + undecided);
    EXPECT_GT(expected, 100U);
}

TEST(Crossings, ThreadsChangeNothing) {
    const scene::Topology topology = soup(9, 600, 0.25F);
    const Crossings one = find_crossings(topology, {.threads = 1});
    const Crossings two = find_crossings(topology, {.threads = 2});
    EXPECT_EQ(comparable(one), comparable(two));
    EXPECT_EQ(one.pairs_tested, two.pairs_tested);
    EXPECT_TRUE(std::is_sorted(
        two.segments.begin(), two.segments.end(), [](const Crossing& x, const Crossing& y) {
            return std::pair(x.face0, x.face1) < std::pair(y.face0, y.face1);
        }));
}

TEST(Crossings, TooManyGiveUpAndSaySo) {
    const scene::Topology topology = soup(9, 600, 0);
    for (const int threads : {1, 2}) {
        const Crossings by_pairs =
            find_crossings(topology, {.threads = threads, .most_pairs = 100});
        EXPECT_TRUE(by_pairs.is_too_many);
        EXPECT_EQ(by_pairs.pairs_tested, 100U);
        EXPECT_TRUE(by_pairs.segments.empty());
        const Crossings by_found = find_crossings(topology, {.threads = threads, .most_found = 10});
        EXPECT_TRUE(by_found.is_too_many);
        EXPECT_TRUE(by_found.segments.empty());
    }
    EXPECT_FALSE(find_crossings(topology, {}).is_too_many);
    EXPECT_FALSE(find_crossings(scene::Topology(), {}).is_too_many);
}

}  // namespace
}  // namespace ink::truth
