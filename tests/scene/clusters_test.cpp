#include "scene/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "catalogue/shapes.h"
#include "scene/predicates.h"
#include "tests/scene/small_meshes.h"

namespace ink::scene {
namespace {

constexpr double kCrease_rad = 40 * std::numbers::pi / 180;

Surface patches(const Mesh& mesh) {
    return flatten(scene_of(mesh), NormalSource::patch, kCrease_rad);
}

/// A ball whose vertices are shaken by up to `by`, in [-1, 1] each way.
Mesh shaken_ball(int levels, double by) {
    Mesh mesh = catalogue::make_icosphere(1, levels);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (glm::vec3& p : mesh.positions)
        p += glm::vec3(glm::dvec3(unit(random), unit(random), unit(random)) * by);
    return mesh;
}

void turn_inside_out(Mesh& mesh) {
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
}

/// Whether all solids of the mesh are watertight; there must be `count`.
bool is_watertight(const Mesh& mesh, std::size_t count = 1) {
    const Clusters clusters = make_clusters(patches(mesh));
    EXPECT_EQ(clusters.solids.size(), count);
    return std::all_of(
        clusters.solids.begin(), clusters.solids.end(), [](auto& s) { return s.is_watertight; });
}

/// The law that holds for every surface: each triangle with an area once, with its own corners.
void expect_partition(const Surface& surface) {
    const Clusters clusters = make_clusters(surface);
    ASSERT_EQ(clusters.triangles.size(), clusters.triangle_ids.size());
    std::vector<int> times(surface.triangles.size(), 0);
    std::size_t vertices = 0, triangles = 0;
    for (const Cluster& cluster : clusters.clusters) {
        EXPECT_EQ(cluster.first_vertex, vertices);
        EXPECT_EQ(cluster.first_triangle, triangles);
        EXPECT_GE(cluster.vertex_count, 3);
        EXPECT_LE(cluster.vertex_count, 64);
        EXPECT_GE(cluster.triangle_count, 1);
        EXPECT_LE(cluster.triangle_count, 124);
        vertices += cluster.vertex_count;
        triangles += cluster.triangle_count;
        ASSERT_LE(vertices, clusters.vertices.size());
        ASSERT_LE(triangles, clusters.triangles.size());
        ASSERT_LT(cluster.solid, clusters.solids.size());
        for (std::size_t k = cluster.first_triangle; k < triangles; ++k) {
            const std::uint32_t id = clusters.triangle_ids[k];
            ++times[id];
            EXPECT_EQ(surface.object[id], clusters.solids[cluster.solid].object);
            for (std::size_t i = 0; i < 3; ++i) {
                ASSERT_LT(clusters.triangles[k][i], cluster.vertex_count);
                EXPECT_EQ(clusters.vertices[cluster.first_vertex + clusters.triangles[k][i]],
                          surface.triangles[id][i]);
            }
        }
        const auto first = clusters.vertices.begin() + cluster.first_vertex;
        EXPECT_EQ(std::set<std::uint32_t>(first, first + cluster.vertex_count).size(),
                  cluster.vertex_count);
    }
    EXPECT_EQ(vertices, clusters.vertices.size());
    for (std::size_t t = 0; t < times.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const bool covers_nothing =
            is_collinear(surface.p_world[a], surface.p_world[b], surface.p_world[c]);
        EXPECT_EQ(times[t], covers_nothing ? 0 : 1);
    }
}

TEST(Clusters, HoldEachTriangleWithAnAreaOnce) {
    Mesh cube = unit_cube();
    cube.triangles.insert(cube.triangles.begin() + 3, Triangle{5, 5, 1});
    cube.triangles.push_back(cube.triangles[0]);
    Scene two = scene_of(shaken_ball(4, 0.02));
    two.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(1, 0, 0)), "other"});
    for (const Scene& scene : {scene_of(cube), two, scene_of(catalogue::make_cone(1, 1, 500))}) {
        for (const auto source : {NormalSource::file, NormalSource::patch, NormalSource::facet})
            expect_partition(flatten(scene, source, kCrease_rad));
        expect_partition(flatten(scene));
    }
}

TEST(Clusters, OfNothingAreNone) {
    Clusters clusters = make_clusters({});
    refresh({}, clusters);
    EXPECT_TRUE(clusters.clusters.empty());
    EXPECT_TRUE(clusters.solids.empty());
    EXPECT_TRUE(clusters.vertices.empty());
}

TEST(Clusters, AreTheSameEveryTime) {
    const Surface surface = patches(shaken_ball(4, 0.02));
    const Clusters one = make_clusters(surface), other = make_clusters(surface);
    EXPECT_EQ(one.vertices, other.vertices);
    EXPECT_EQ(one.triangles, other.triangles);
    EXPECT_EQ(one.triangle_ids, other.triangle_ids);
}

TEST(Clusters, OfASmoothBallAreNearlyFull) {
    const Clusters clusters = make_clusters(patches(catalogue::make_icosphere(1, 5)));
    const std::size_t count = clusters.clusters.size();
    EXPECT_GE(clusters.vertices.size(), 48 * count);
    EXPECT_GE(clusters.triangles.size(), 85 * count);
}

TEST(Clusters, OfFacetsFillUpOverEdgesThatShareNoCorner) {
    const Surface surface =
        flatten(scene_of(catalogue::make_icosphere(1, 4)), NormalSource::facet, kCrease_rad);
    const Clusters clusters = make_clusters(surface);
    EXPECT_EQ(clusters.solids.size(), 1U);
    EXPECT_GE(clusters.triangles.size(), 16 * clusters.clusters.size());
}

TEST(Clusters, LieInTheirBalls) {
    const Surface surface = patches(shaken_ball(4, 0.02));
    const Clusters clusters = make_clusters(surface);
    for (const Cluster& cluster : clusters.clusters) {
        for (std::uint32_t v = 0; v < cluster.vertex_count; ++v) {
            const glm::dvec3 p = surface.p_world[clusters.vertices[cluster.first_vertex + v]];
            EXPECT_LE(glm::length(p - cluster.bounds.center_world), cluster.bounds.radius);
            const Sphere& all = clusters.solids[cluster.solid].bounds;
            EXPECT_LE(glm::length(p - all.center_world), all.radius);
        }
    }
}

TEST(Seal, ClosesBoxesBallsAndRings) {
    EXPECT_TRUE(is_watertight(unit_cube()));
    EXPECT_TRUE(is_watertight(catalogue::make_icosphere(1, 3)));
    EXPECT_TRUE(is_watertight(catalogue::make_torus({2, 0.5}, {24, 12})));
}

TEST(Seal, IsBrokenByAHole) {
    Mesh open = catalogue::make_icosphere(1, 3);
    open.triangles.pop_back();
    EXPECT_FALSE(is_watertight(open));
    EXPECT_FALSE(is_watertight(catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
}

TEST(Seal, IsBrokenByTurningInsideOut) {
    Mesh ball = catalogue::make_icosphere(1, 3);
    turn_inside_out(ball);
    EXPECT_FALSE(is_watertight(ball));
}

TEST(Seal, IsBrokenByOneFaceThatIsTurned) {
    Mesh cube = unit_cube();
    std::swap(cube.triangles[4][0], cube.triangles[4][1]);
    EXPECT_FALSE(is_watertight(cube));
}

TEST(Seal, IsBrokenByDuplicatesAndByFacesWithoutArea) {
    Mesh twice = unit_cube();
    twice.triangles.push_back(twice.triangles[0]);
    EXPECT_FALSE(is_watertight(twice));

    Mesh two_sided = catalogue::make_sheet({0.1, 0.2, 0.3}, {1, 0.1, 0}, {0, 1, 0.7}, {5, 7});
    Mesh back = two_sided;
    turn_inside_out(back);
    catalogue::append(two_sided, back);
    EXPECT_FALSE(is_watertight(two_sided));

    // A triangle with its middle on an edge: (0, 8, 1) closes the gap and covers nothing.
    Mesh split = unit_cube();
    split.positions.emplace_back(0, -1, -1);
    split.triangles[1] = {0, 3, 8};
    split.triangles.push_back({3, 1, 8});
    split.triangles.push_back({0, 8, 1});
    EXPECT_FALSE(is_watertight(split));

    Mesh needle = unit_cube();  // two corners in one place: no edge of it is anybody's
    needle.triangles.push_back({0, 0, 3});
    EXPECT_TRUE(is_watertight(needle));
}

TEST(Seal, IsEachSolidsOwn) {
    Mesh hollow = catalogue::make_icosphere(2, 3);
    Mesh cavity = catalogue::make_icosphere(1, 3);
    turn_inside_out(cavity);
    catalogue::append(hollow, cavity);
    const Clusters clusters = make_clusters(patches(hollow));
    ASSERT_EQ(clusters.solids.size(), 2U);
    EXPECT_TRUE(clusters.solids[0].is_watertight);
    EXPECT_FALSE(clusters.solids[1].is_watertight);
}

TEST(Seal, OfTwoObjectsThatTouchIsNotShared) {
    Scene scene = scene_of(unit_cube());
    scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(2, 0, 0)), "other"});
    for (const double crease_rad : {kCrease_rad, 3.0}) {
        const Clusters clusters = make_clusters(flatten(scene, NormalSource::patch, crease_rad));
        ASSERT_EQ(clusters.solids.size(), 2U);
        EXPECT_TRUE(clusters.solids[0].is_watertight);
        EXPECT_TRUE(clusters.solids[1].is_watertight);
        EXPECT_EQ(clusters.solids[1].object, 1U);
    }
}

TEST(Seal, TakesZeroAndMinusZeroForOnePlace) {
    Mesh cube = unit_cube();
    for (glm::vec3& p : cube.positions)
        p = (p + 1.0F) * 0.5F;
    Mesh split = cube;
    split.positions.clear();
    for (Triangle& t : split.triangles) {
        for (std::uint32_t& v : t) {
            split.positions.push_back(cube.positions[v]);
            v = static_cast<std::uint32_t>(split.positions.size() - 1);
            if (v % 2 == 0 && split.positions[v].x == 0) split.positions[v].x = -0.0F;
        }
    }
    Surface surface = flatten(scene_of(split));
    for (std::size_t i = 0; i < surface.p_world.size(); ++i)
        surface.p_world[i] = split.positions[i];  // placing by a matrix would lose the sign
    const Clusters clusters = make_clusters(surface);
    ASSERT_EQ(clusters.solids.size(), 1U);
    EXPECT_TRUE(clusters.solids[0].is_watertight);
}

// Exact for every face, from anywhere: near, far, beside, inside, and in parallel.
TEST(TurnedAway, ClustersShowTheirBacksOnly) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (const double shake : {0.0, 0.02, 0.1}) {
        const Surface surface = patches(shaken_ball(4, shake));
        const Clusters clusters = make_clusters(surface);
        std::size_t away = 0, trials = 0;
        for (int i = 0; i < 200; ++i) {
            const double distance = std::exp(normal(random));
            const Viewpoint eye{
                glm::dvec3(normal(random), normal(random), normal(random)) * distance, i % 3 == 0};
            for (const Cluster& cluster : clusters.clusters) {
                ++trials;
                if (!is_turned_away(cluster, eye)) continue;
                ++away;
                for (std::size_t k = 0; k < cluster.triangle_count; ++k) {
                    const auto& [a, b, c] =
                        surface.triangles[clusters.triangle_ids[cluster.first_triangle + k]];
                    ASSERT_EQ(
                        facing(surface.p_world[a], surface.p_world[b], surface.p_world[c], eye),
                        -1);
                }
            }
        }
        if (shake < 0.1) {
            EXPECT_GT(away, trials / 4);
        }
    }
}

// One face is one cluster, whose test is then all but exact.
TEST(TurnedAway, AFlatSheetFromJustBehindAndNotFromItsPlane) {
    const Clusters clusters =
        make_clusters(flatten(scene_of(catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}))));
    ASSERT_EQ(clusters.clusters.size(), 1U);
    EXPECT_TRUE(is_turned_away(clusters.clusters[0], {{0.5, 0.5, -0.01}}));
    EXPECT_TRUE(is_turned_away(clusters.clusters[0], {{0.9, 0.1, -100}}));
    EXPECT_FALSE(is_turned_away(clusters.clusters[0], {{0.5, 0.5, 0.01}}));
    EXPECT_FALSE(is_turned_away(clusters.clusters[0], {{3, 0.5, 0}}));
}

TEST(TurnedAway, NormalsThatPointAllWaysHaveNoCone) {
    const Clusters clusters = make_clusters(flatten(scene_of(unit_cube())));
    ASSERT_EQ(clusters.clusters.size(), 1U);
    EXPECT_GE(clusters.clusters[0].cone_sine, 1);
    EXPECT_FALSE(is_turned_away(clusters.clusters[0], {{9, 9, 9}}));
}

TEST(TurnedAway, ANeedleWhoseNormalIsLostInRoundingHasNoCone) {
    Mesh needle;
    needle.positions = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3.0000002F}};
    needle.triangles = {{0, 1, 2}};
    Surface surface = flatten(scene_of(needle));
    surface.p_world[2].z = std::nextafter(3.0, 4.0);
    const Clusters clusters = make_clusters(surface);
    ASSERT_EQ(clusters.clusters.size(), 1U);
    EXPECT_GE(clusters.clusters[0].cone_sine, 1);
}

TEST(Refresh, GivesWhatMakingGives) {
    const Surface before = patches(shaken_ball(3, 0.02));
    Clusters refreshed = make_clusters(before);
    Surface after = before;
    for (glm::dvec3& p : after.p_world)
        p = p * 2.0 + glm::dvec3(1, 2, 3);  // exact enough to grow the same clusters
    refresh(after, refreshed);
    const Clusters remade = make_clusters(after);
    ASSERT_EQ(refreshed.triangle_ids, remade.triangle_ids);
    for (std::size_t i = 0; i < remade.clusters.size(); ++i) {
        const Cluster &a = refreshed.clusters[i], &b = remade.clusters[i];
        EXPECT_EQ(a.bounds.center_world, b.bounds.center_world);
        EXPECT_EQ(a.bounds.radius, b.bounds.radius);
        EXPECT_EQ(a.cone_axis, b.cone_axis);
        EXPECT_EQ(a.cone_sine, b.cone_sine);
        EXPECT_EQ(a.center_height, b.center_height);
    }
    EXPECT_EQ(refreshed.solids[0].bounds.radius, remade.solids[0].bounds.radius);
    EXPECT_NEAR(refreshed.solids[0].bounds.radius, 2, 0.2);
}

TEST(Refresh, OpensASolidThatTurnsInsideOutOrComesApart) {
    const Surface surface = flatten(scene_of(unit_cube()), NormalSource::facet, kCrease_rad);
    Clusters clusters = make_clusters(surface);
    ASSERT_TRUE(clusters.solids[0].is_watertight);

    Surface mirrored = surface;
    for (glm::dvec3& p : mirrored.p_world)
        p.x = -p.x;
    refresh(mirrored, clusters);
    EXPECT_FALSE(clusters.solids[0].is_watertight);

    Surface torn = surface;
    torn.p_world[surface.triangles[5][0]].z += 0.5;  // one of the corners at that place
    refresh(torn, clusters);
    EXPECT_FALSE(clusters.solids[0].is_watertight);

    refresh(surface, clusters);
    EXPECT_TRUE(clusters.solids[0].is_watertight);
}

TEST(Refresh, TakesInATriangleThatGetsAnArea) {
    Mesh mesh = catalogue::make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.positions.emplace_back(2, 0, 0);
    mesh.triangles.push_back({0, 1, 4});
    Surface surface = flatten(scene_of(mesh));
    Clusters clusters = make_clusters(surface);
    ASSERT_EQ(clusters.triangle_ids.size(), 2U);
    surface.p_world[4].y = -1;
    refresh(surface, clusters);
    EXPECT_EQ(clusters.triangle_ids.size(), 3U);
}

}  // namespace
}  // namespace ink::scene
