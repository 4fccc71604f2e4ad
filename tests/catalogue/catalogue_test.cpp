#include "catalogue/catalogue.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <set>

#include "catalogue/shapes.h"
#include "core/error.h"
#include "scene/topology.h"
#include "tests/core/error_text.h"
#include "tests/scene/edge_counts.h"

namespace ink::catalogue {
namespace {

/// What a scene of the catalogue is known by. A new scene needs its row here.
struct Golden {
    const char* name;
    bool is_closed;  ///< every solid closed, every edge consistently oriented
    std::size_t triangles;
    std::uint64_t hash;
};

const Golden kGolden[] = {
    {"sphere", true, 3968, 0x555e1ba541dce3e1ULL},
    {"balls", true, 17920, 0xb61e6c36fc50981aULL},
    {"torus", true, 7680, 0x4aa10e79701ced58ULL},
    {"cube", true, 36, 0xe5dcbff3055106a3ULL},
    {"cylinder", true, 920, 0x78c3cd83063a6008ULL},
    {"cone", true, 296, 0xc83f40d6979e4162ULL},
    {"blocks", true, 60, 0x7902c00892215fd1ULL},
    {"horizon", true, 9996, 0xe42104348cfdcc54ULL},
    {"tiles", false, 64, 0x4b643d28dcc863f5ULL},
    {"layers", false, 32, 0x59ec3f7b20e1d475ULL},
    {"hills", false, 24576, 0xf163b51ac61ad24cULL},
    {"soup", false, 9216, 0xb1005df698264eedULL},
    {"gear", true, 1648, 0x8446f21e56b2af28ULL},
    {"figure", true, 22020, 0xf3555bccd2403376ULL},
    {"octopus", true, 40672, 0x6e95a8b68f607ea9ULL},
    {"scan", false, 316792, 0x3f93e28c79403825ULL},
    {"truss", true, 8064, 0x56c1dfb0ce253eeeULL},
    {"bracket", true, 3788, 0x1937765cba09b10aULL},
    {"teapot", false, 6320, 0x7481be65a178fa7dULL},
    {"rocket", true, 100, 0x32b552ebea5bac76ULL},
    {"gem", true, 148, 0x772951bc5b265114ULL},
    {"crystals", true, 416, 0x90b1ada66418812eULL},
    {"letters", true, 124, 0x37dbb849343fdc35ULL},
    {"knot", true, 9216, 0x47af604b2b75c6e5ULL},
    {"chess", true, 16764, 0x1c65b4b4346c8356ULL},
    {"flag", false, 13216, 0xe6d0350e176f14c5ULL},
    {"tree", true, 16128, 0x2f13409d02ed26ecULL},
    {"staircase", true, 144, 0x5472b237800939ecULL},
    {"spiral", true, 2208, 0x13a4d9d40b9965ffULL},
    {"fence", true, 792, 0x52d8575713000e07ULL},
    {"room", false, 4728, 0x6076417af277890cULL},
    {"hand", true, 22592, 0x7cfe8badd32fbdd2ULL},
    {"drapery", false, 58032, 0x688cd1e844180814ULL},
    {"globe", true, 1001472, 0x213c4521bf9410afULL},
    {"bush", false, 8832, 0x6597ac5dd9c5b14fULL},
    {"bars", false, 386, 0xb320275203002926ULL},
};

const Golden* golden_of(const std::string& name) {
    const auto* const row = std::find_if(
        std::begin(kGolden), std::end(kGolden), [&](const Golden& g) { return name == g.name; });
    return row == std::end(kGolden) ? nullptr : row;
}

/// How often the mesh goes round the eye: 1 inside a closed solid, 0 outside, in between for
/// sheets. Van Oosterom and Strackee 1983, "The solid angle of a plane triangle".
double winding(const scene::Scene& scene,
               const scene::Instance& instance,
               const glm::dvec3& eye_world) {
    double sum = 0;
    const scene::Mesh& mesh = scene.meshes[instance.mesh];
    for (const scene::Triangle& triangle : mesh.triangles) {
        glm::dvec3 p[3];
        for (int i = 0; i < 3; ++i) {
            p[i] =
                glm::normalize(scene::to_world(instance, mesh.positions[triangle[i]]) - eye_world);
        }
        const double volume = glm::dot(p[0], glm::cross(p[1], p[2]));
        const double sides = 1 + glm::dot(p[0], p[1]) + glm::dot(p[1], p[2]) + glm::dot(p[2], p[0]);
        sum += std::atan2(volume, sides);
    }
    return sum / (2 * std::numbers::pi);
}

/// The half-width and half-height of all vertices in the frame of 16 by 9, as shares of the
/// frame's.
glm::dvec2 filled_share(const scene::Scene& scene, const scene::Camera& camera) {
    const scene::Projection projection(scene::View{camera, 1600, 900});
    glm::dvec2 share{0};
    for (const scene::Instance& instance : scene.instances) {
        for (const auto& p : scene.meshes[instance.mesh].positions) {
            const glm::dvec3 clip = projection.to_clip(scene::to_world(instance, p));
            if (clip.z <= 0) return {INFINITY, INFINITY};
            share =
                glm::max(share, glm::abs(glm::dvec2(clip) / clip.z / glm::dvec2(800, 450) - 1.0));
        }
    }
    return share;
}

TEST(Catalogue, EveryRowOfTheGoldenTableIsAScene) {
    std::vector<std::string> golden;
    for (const auto& row : kGolden)
        golden.emplace_back(row.name);
    std::vector<std::string> names;
    for (const auto& entry : catalogue())
        names.push_back(entry.name);
    EXPECT_EQ(names, golden);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
}

TEST(Catalogue, IsTheSameOnEveryMachine) {
    for (const auto& entry : catalogue()) {
        const Golden* row = golden_of(entry.name);
        ASSERT_NE(row, nullptr) << entry.name;
        const scene::Scene scene = entry.make();
        EXPECT_EQ(scene::triangle_count(scene), row->triangles) << entry.name;
        EXPECT_EQ(scene::scene_hash(scene), row->hash)
            << entry.name << std::hex << " 0x" << scene::scene_hash(scene);
    }
}

TEST(Catalogue, ScenesCarryNameSplitLightsAndViews) {
    for (const auto& entry : catalogue()) {
        const scene::Scene scene = entry.make();
        EXPECT_EQ(scene.name, entry.name);
        EXPECT_EQ(scene.split, entry.split) << entry.name;
        EXPECT_FALSE(entry.summary.empty()) << entry.name;
        EXPECT_EQ(scene.lights.size(), 2U) << entry.name;
        EXPECT_GE(scene.cameras.size(), 2U) << entry.name;
        EXPECT_GE(scene::triangle_count(scene), 10U) << entry.name;
        const bool is_fine = entry.name == "scan" || entry.name == "globe";
        EXPECT_LE(scene::triangle_count(scene), is_fine ? 1100000U : 60000U) << entry.name;
        std::set<std::string> views;
        for (const scene::Camera& camera : scene.cameras)
            views.insert(camera.name);
        EXPECT_EQ(views.size(), scene.cameras.size()) << entry.name << " has two views of one name";
    }
}

TEST(Catalogue, BothSplitsHoldAsMany) {
    const auto& all = catalogue();
    for (const scene::Split split : {scene::Split::train, scene::Split::heldout})
        EXPECT_EQ(std::ranges::count(all, split, &CatalogueEntry::split), 18);
}

TEST(Catalogue, ClosedScenesAreClosedAndOriented) {
    for (const auto& entry : catalogue()) {
        const Golden* row = golden_of(entry.name);
        ASSERT_NE(row, nullptr) << entry.name;
        const scene::Topology topology = scene::weld(entry.make());
        const scene::TopologyCounts& counts = topology.counts;
        const scene::EdgeCounts edges = scene::edge_counts(topology);
        EXPECT_EQ(counts.degenerate, 0U) << entry.name;
        EXPECT_EQ(counts.duplicate, 0U) << entry.name;
        EXPECT_EQ(edges.nonmanifold, 0U) << entry.name;
        EXPECT_EQ(edges.inconsistent, 0U) << entry.name;
        EXPECT_EQ(edges.boundary == 0, row->is_closed) << entry.name;
    }
}

TEST(Catalogue, EyesStandOutsideOfSolids) {
    for (const auto& entry : catalogue()) {
        const scene::Scene scene = entry.make();
        for (const scene::Instance& instance : scene.instances) {
            if (instance.name == "shell") continue;  // the room is seen from inside
            for (const scene::Camera& camera : scene.cameras) {
                EXPECT_LT(std::abs(winding(scene, instance, camera.eye_world)), 0.5)
                    << entry.name << ", " << camera.name << ", " << instance.name;
            }
        }
    }
}

TEST(Catalogue, EyesOfTheRoomStandInside) {
    const scene::Scene room = make_catalogue_scene("room");
    ASSERT_EQ(room.instances[0].name, "shell");
    for (const scene::Camera& camera : room.cameras) {
        // Its fronts look inwards, and the window lets part of the sphere out.
        EXPECT_LT(winding(room, room.instances[0], camera.eye_world), -0.5) << camera.name;
    }
}

TEST(Catalogue, ThreeQuarterViewsFillTheFrame) {
    for (const auto& entry : catalogue()) {
        const scene::Scene scene = entry.make();
        for (const scene::Camera& camera : scene.cameras) {
            if (camera.name != "three_quarter" || entry.name == "horizon") continue;
            const glm::dvec2 share = filled_share(scene, camera);
            EXPECT_NEAR(std::max(share.x, share.y), 0.92, 1e-4) << entry.name;
        }
    }
}

TEST(Catalogue, ClipRangesHoldWhatIsSeen) {
    for (const auto& entry : catalogue()) {
        const scene::Scene scene = entry.make();
        for (const scene::Camera& camera : scene.cameras) {
            const scene::Projection projection(scene::View{camera, 1600, 900});
            EXPECT_GT(camera.near, 0);
            for (const scene::Instance& instance : scene.instances) {
                for (const auto& p : scene.meshes[instance.mesh].positions) {
                    const glm::dvec3 clip = projection.to_clip(scene::to_world(instance, p));
                    const glm::dvec2 px = glm::dvec2(clip) / clip.z;
                    const bool is_seen =
                        clip.z > 0 && px.x > 0 && px.y > 0 && px.x < 1600 && px.y < 900;
                    if (!is_seen) continue;
                    EXPECT_GE(clip.z, camera.near) << entry.name << ", " << camera.name;
                    EXPECT_LE(clip.z, camera.far) << entry.name << ", " << camera.name;
                }
            }
        }
    }
}

TEST(Catalogue, TilesAbutExactly) {
    // 58 sides in a grid of 5 by 7, less 11 of the missing tiles and 12 between two heights.
    const scene::Topology topology = scene::weld(make_catalogue_scene("tiles"));
    const auto seams =
        std::count_if(topology.edges.begin(), topology.edges.end(), [&](const scene::Edge& edge) {
            const auto faces = topology.faces_of(edge);
            return faces.size() == 2 &&
                   topology.faces[faces[0]].object != topology.faces[faces[1]].object;
        });
    EXPECT_EQ(seams, 35);
}

TEST(Catalogue, UnknownSceneListsTheKnownOnes) {
    EXPECT_THAT(
        core::error_text([] { return make_catalogue_scene("torsu"); }),
        testing::AllOf(
            testing::HasSubstr("torsu"), testing::HasSubstr("torus"), testing::HasSubstr("room")));
    EXPECT_THROW((void)make_catalogue_scene(""), core::Error);
}

}  // namespace
}  // namespace ink::catalogue
