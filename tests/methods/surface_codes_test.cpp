// What codes of surface distance hold on any mesh, over random ones, and what they hold on plain
// ones by count.

#include "methods/surface_codes/surface_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <random>

#include "catalogue/shapes.h"
#include "methods/surface_codes/surface_distance.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {
namespace {

using scene::scene_of;
using Random = std::mt19937;

double share(Random& random) {
    return static_cast<double>(random() % 1000) / 1000;
}

/// A sheet of n x n squares with a height of its own at every vertex.
scene::Mesh sheet(std::uint32_t n, const std::function<double(double, double)>& height) {
    return catalogue::make_sheet(glm::ivec2(static_cast<int>(n)), [&](double u, double v) {
        return glm::dvec3(u, height(u, v), v);
    });
}

/// Waves and noise, from hardly bent to full of creases; some faces turned, some unwelded, some
/// without area, some there twice.
scene::Mesh random_mesh(int seed) {
    Random random(static_cast<Random::result_type>(seed));
    const double waves = 1 + 6 * share(random), tall = 0.3 * share(random);
    const double noise = seed % 3 == 0 ? 0 : 0.06 * share(random);
    scene::Mesh mesh =
        sheet(static_cast<std::uint32_t>(3 + random() % 20), [&](double u, double v) {
            return tall * std::sin(waves * u) * std::cos(waves * v) + noise * share(random);
        });
    for (scene::Triangle& t : mesh.triangles) {
        if (random() % 20 == 0) std::swap(t[0], t[1]);
        if (random() % 20 == 0) {
            mesh.positions.push_back(mesh.positions[t[2]]);
            t[2] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
        }
    }
    mesh.triangles.push_back(mesh.triangles[random() % mesh.triangles.size()]);
    mesh.triangles.push_back({0, 1, 0});
    return mesh;
}

CodeOptions options(double turn_deg = 5) {
    CodeOptions options;
    options.patches = {.crease_rad = 0.7, .weld_epsilon = 1e-4};
    options.turn_rad = turn_deg * M_PI / 180;
    options.rounds = 10;
    return options;
}

SurfaceCodes prepared(const scene::Scene& scene, double turn_deg = 5) {
    SurfaceCodes made(options(turn_deg));
    made.prepare(scene);
    return made;
}

class RandomMesh : public testing::TestWithParam<int> {
  protected:
    const scene::Scene scene_ = scene_of(random_mesh(GetParam()));
    /// One in three without a footprint.
    const std::vector<float> lengths_ =
        GetParam() % 3 == 1
            ? std::vector<float>()
            : std::vector<float>(scene::triangle_count(scene_), GetParam() % 2 ? 0.01F : 0.2F);
};

TEST_P(RandomMesh, CodesOfFacesThatTouchInASmoothPatchDifferByAStepAtMost) {
    SurfaceCodes made = prepared(scene_);
    const std::vector<std::uint32_t> codes = made.codes(lengths_);
    const SmoothMesh& mesh = made.mesh();
    const auto code = [&](std::uint32_t face) {
        return static_cast<int>(codes[mesh.topology.faces[face].triangle]);
    };
    const SurfaceGraph graph(mesh, {.turn_rad = 0.1, .length_world = {}});
    std::map<std::uint32_t, std::pair<int, int>> range_of_fan;
    for (std::uint32_t corner = 0; corner < mesh.fan_of.size(); ++corner) {
        const std::uint32_t fan = mesh.fan_of[corner];
        const int c = code(corner / 3);
        const std::uint32_t across = mesh.across[corner];
        if (across != SmoothMesh::kNone) {
            EXPECT_LE(std::abs(c - code(across)), 1);
        }
        if (graph.is_slit_end(fan)) continue;
        auto& [low, high] = range_of_fan.try_emplace(fan, c, c).first->second;
        low = std::min(low, c);
        high = std::max(high, c);
    }
    for (const auto& [fan, range] : range_of_fan)
        EXPECT_LE(range.second - range.first, 1) << "fan " << fan;
}

TEST_P(RandomMesh, CodesLieInTheirRangeAndComeOutAlikeAgain) {
    SurfaceCodes made = prepared(scene_);
    const auto codes = made.codes(lengths_);
    ASSERT_EQ(codes.size(), scene::triangle_count(scene_));
    EXPECT_GE(*std::min_element(codes.begin(), codes.end()), 2U);
    EXPECT_LE(*std::max_element(codes.begin(), codes.end()), 255U);
    EXPECT_EQ(made.codes(lengths_), codes);
    EXPECT_EQ(prepared(scene_).codes(lengths_), codes);
    // A triangle that repeats a face has its code.
    const auto& triangles = scene_.meshes[0].triangles;
    const scene::Triangle& twice = triangles[triangles.size() - 2];
    const auto first = std::find(triangles.begin(), triangles.end(), twice);
    EXPECT_EQ(codes[triangles.size() - 2],
              codes[static_cast<std::size_t>(first - triangles.begin())]);
}

TEST_P(RandomMesh, DistancesDifferByNoMoreThanWaysCost) {
    const SmoothMesh mesh = *make_smooth_mesh(scene_, options().patches);
    for (const double turn_rad : {0.02, 0.5}) {
        SurfaceGraph graph(mesh, {.turn_rad = turn_rad, .length_world = {}});
        if (GetParam() % 3 == 0) steepen_short_slits(mesh, graph);
        const std::vector<std::int32_t> distances = surface_distance(mesh, graph, 10);
        for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
            EXPECT_GE(distances[face], 0);
            graph.for_each_way(face, [&](std::uint32_t to, std::int32_t cost) {
                EXPECT_GE(cost, 0);
                EXPECT_LE(cost, kStep);
                if (to < mesh.face_count()) {
                    EXPECT_LE(std::abs(distances[face] - distances[to]), cost);
                    return;
                }
                graph.for_each_way(to, [&](std::uint32_t far, std::int32_t more) {
                    EXPECT_LE(std::abs(distances[face] - distances[far]), cost + more);
                });
            });
        }
    }
}

constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max() / 2;

/// The cost of the shortest way from a face to each node.
std::vector<std::int32_t> ways_from(const SurfaceGraph& graph, std::uint32_t from) {
    std::vector<std::int32_t> keys(graph.node_count(), kFar);
    keys[from] = 0;
    spread(graph, std::vector<std::uint32_t>{from}, keys);
    return keys;
}

TEST_P(RandomMesh, SpreadFindsTheShortestWays) {
    const SmoothMesh mesh = *make_smooth_mesh(scene_, options().patches);
    const SurfaceGraph graph(mesh, {.turn_rad = 0.1, .length_world = {}});
    // Bellman and Ford's: relax all ways until nothing gives.
    std::vector<std::int64_t> plain(graph.node_count(), kFar);
    plain[0] = 0;
    for (bool gives = true; gives;) {
        gives = false;
        for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
            graph.for_each_way(node, [&](std::uint32_t to, std::int32_t cost) {
                if (plain[to] <= plain[node] + cost) return;
                plain[to] = plain[node] + cost;
                gives = true;
            });
        }
    }
    const std::vector<std::int32_t> keys = ways_from(graph, 0);
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face)
        EXPECT_EQ(keys[face], plain[face]) << face;
}

INSTANTIATE_TEST_SUITE_P(Many, RandomMesh, testing::Range(0, 60));

/// A roof whose ridge ends in the middle of a bent sheet: creased in front, smooth behind.
scene::Mesh roof(std::uint32_t n) {
    return sheet(n, [](double u, double v) {
        const double steep = std::max(0.0, 0.75 - v) * 1.6;
        return 0.15 * std::sin(3 * v) - steep * std::abs(u - 0.5);
    });
}

TEST(SurfaceCodes, PartsBothSidesOfACreaseThatEndsInsideAPatch) {
    const scene::Scene scene = scene_of(roof(24));
    SurfaceCodes made = prepared(scene);
    const auto codes = made.codes({});
    const SmoothMesh& mesh = made.mesh();
    ASSERT_EQ(mesh.patch_count, 1U);
    const SurfaceGraph graph(mesh, {.turn_rad = options().turn_rad, .length_world = {}});
    int far_apart = 0;
    for (const FacePair& pair : mesh.borders) {
        if (ways_from(graph, pair.face0)[pair.face1] < 3 * kStep) continue;
        ++far_apart;
        const auto c = [&](std::uint32_t f) {
            return static_cast<int>(codes[mesh.topology.faces[f].triangle]);
        };
        EXPECT_GE(std::abs(c(pair.face0) - c(pair.face1)), 2);
    }
    EXPECT_GE(far_apart, 6);
}

TEST(SurfaceCodes, LiftingPartsWhatDistanceAloneDoesNot) {
    std::size_t edges = 0, parted = 0, parted_alone = 0;
    for (int seed = 0; seed < 60; ++seed) {
        const SmoothMesh mesh = *make_smooth_mesh(scene_of(random_mesh(seed)), options().patches);
        const SurfaceGraph graph(mesh, {.turn_rad = options().turn_rad, .length_world = {}});
        SlitCount lifted, alone;
        (void)surface_distance(mesh, graph, 10, &lifted);
        (void)surface_distance(mesh, graph, 0, &alone);
        EXPECT_EQ(lifted.edges, alone.edges);
        edges += lifted.edges;
        parted += lifted.parted;
        parted_alone += alone.parted;
    }
    EXPECT_GT(edges, 100U);
    EXPECT_GT(parted, edges * 9 / 10);
    EXPECT_LT(parted_alone, parted);
}

/// Creases of random meshes that have one patch on both sides.
std::size_t count_inner_creases(const SmoothMesh& mesh) {
    return static_cast<std::size_t>(
        std::count_if(mesh.borders.begin(), mesh.borders.end(), [&](const FacePair& pair) {
            return mesh.patch_of[pair.face0] == mesh.patch_of[pair.face1];
        }));
}

TEST(SurfaceCodes, SteepWaysPartCreasesTooShortForOthers) {
    std::size_t creases = 0, parted = 0, parted_before = 0;
    for (int seed = 0; seed < 60; ++seed) {
        const scene::Scene scene = scene_of(random_mesh(seed));
        const SmoothMesh mesh = *make_smooth_mesh(scene, options().patches);
        // Triangles far below the length of a step: without steep ways all is level.
        SurfaceGraph graph(mesh,
                           {.turn_rad = options().turn_rad,
                            .length_world = std::vector<float>(mesh.face_count(), 5.0F)});
        SlitCount before, after;
        (void)surface_distance(mesh, graph, 10, &before);
        steepen_short_slits(mesh, graph);
        (void)surface_distance(mesh, graph, 10, &after);
        creases += count_inner_creases(mesh);
        parted_before += before.parted;
        parted += after.parted;
    }
    EXPECT_GT(creases, 100U);
    EXPECT_LT(parted_before, creases / 10);
    EXPECT_GT(parted, creases * 3 / 4);
}

TEST(SurfaceCodes, NeighboursOverCreasesDiffer) {
    // A staircase of 40 treads and risers: one code each.
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i <= 40; ++i) {
        const auto z = static_cast<float>((i + 1) / 2), y = static_cast<float>(i / 2);
        mesh.positions.push_back({0, y, z});
        mesh.positions.push_back({5, y, z});
    }
    for (std::uint32_t i = 0; i < 40; ++i) {
        mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
        mesh.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
    }
    SurfaceCodes made = prepared(scene_of(mesh));
    const auto codes = made.codes({});
    EXPECT_EQ(made.mesh().patch_count, 40U);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(codes[2 * i], codes[2 * i + 1]);
        if (i > 0) {
            EXPECT_GE(std::abs(static_cast<int>(codes[2 * i]) - static_cast<int>(codes[2 * i - 2])),
                      2);
        }
    }
}

std::uint32_t spread_of(const std::vector<std::uint32_t>& codes) {
    const auto [low, high] = std::minmax_element(codes.begin(), codes.end());
    return *high - *low;
}

TEST(SurfaceCodes, AFlatSheetHasOneCodeAndAPatchWithoutTurning) {
    const scene::Scene flat = scene_of(sheet(30, [](double, double) { return 0.0; }));
    EXPECT_EQ(spread_of(prepared(flat, 0.1).codes({})), 0U);
    EXPECT_EQ(spread_of(prepared(scene_of(roof(12)), 0).codes({})), 0U);
}

TEST(SurfaceCodes, StayWhileInstancesMoveAndForFacesTurnedOver) {
    scene::Scene scene = scene_of(random_mesh(4));
    SurfaceCodes made = prepared(scene);
    const auto codes = made.codes({});
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1), {8, -2, 0.5});
    made.prepare(scene);
    EXPECT_EQ(made.codes({}), codes);
    for (scene::Triangle& t : scene.meshes[0].triangles)
        std::swap(t[1], t[2]);
    made.prepare(scene);
    EXPECT_EQ(made.codes({}), codes);
}

TEST(SurfaceCodes, AnEmptySceneHasNone) {
    SurfaceCodes made = prepared({});
    EXPECT_TRUE(made.codes({}).empty());
    EXPECT_EQ(made.largest_object(), 0);
}

}  // namespace
}  // namespace ink::methods
