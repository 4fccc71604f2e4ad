// Parts that were made to touch are the same in every pose, though each pose rounds their vertices
// anew; a gap is one where the image can show it.

#include <glm/gtc/quaternion.hpp>
#include <random>

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

/// The scene, each vertex turned and rounded to float as a file would have it, and the camera with
/// it.
struct Posed {
    scene::Scene scene;
    scene::View view;
};

Posed turned(scene::Scene scene, scene::View view, const glm::dmat3& rotation) {
    for (scene::Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions)
            p = glm::vec3(rotation * glm::dvec3(p));
    }
    view.camera.eye_world = rotation * view.camera.eye_world;
    view.camera.view_from_world = view.camera.view_from_world * glm::transpose(rotation);
    return {std::move(scene), view};
}

glm::dmat3 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::mat3_cast(
        glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random))));
}

/// Expects the lengths that the scene has as it stands, class by class, in twenty other poses.
void expect_the_same_in_every_pose(const scene::Scene& scene, const scene::View& view) {
    const auto expected = lengths(trace(scene, view));
    std::mt19937 random(7);
    for (int i = 0; i < 20; ++i) {
        const Posed posed = turned(scene, view, random_rotation(random));
        auto found = lengths(trace(posed.scene, posed.view));
        for (const LineClass c : kLineClasses) {
            const auto at = expected.find(c);
            const double length = at == expected.end() ? 0 : at->second;
            EXPECT_NEAR(found[c], length, 0.05 + 1e-4 * length) << name(c) << ", pose " << i;
        }
    }
}

const scene::Mesh kPlate = quad({-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0});

TEST(TouchingParts, ASheetBehindAPlateIsNotSeenThroughIt) {
    const scene::Mesh sheet = quad({-1, 0.3F, 0}, {1, 0.3F, 0}, {1, 0.3F, -1}, {-1, 0.3F, -1});
    const scene::Scene scene = scene_of({kPlate, sheet});
    const auto seen = lengths(trace(scene, view_from({1, -2, 6}, {0, 0, 0})));
    EXPECT_EQ(seen.size(), 1U) << "the borders of the plate alone";
    expect_the_same_in_every_pose(scene, view_from({1, -2, 6}, {0, 0, 0}));
}

TEST(TouchingParts, ADecalIsASeamWhereObjectsDiffer) {
    const scene::Mesh decal =
        quad({-0.7F, -0.4F, 0}, {0.9F, -0.3F, 0}, {0.7F, 0.5F, 0}, {-0.9F, 0.2F, 0});
    // Of coplanar faces the first is seen.
    const scene::Scene two_objects = scene_of({decal, kPlate});
    EXPECT_GT(lengths(trace(two_objects, view_from(6)))[LineClass::seam], 400);
    expect_the_same_in_every_pose(two_objects, view_from({1, -2, 6}, {0, 0, 0}));
    const scene::Mesh both = joined({decal, kPlate});
    EXPECT_EQ(lengths(trace(scene_of({both}), view_from(6))).size(), 1U) << "borders of the plate";
    expect_the_same_in_every_pose(scene_of({both}), view_from({1, -2, 6}, {0, 0, 0}));
}

TEST(TouchingParts, TheFootOfAWallIsSeenWhereItsPlaneAndTheFloorBothGoOn) {
    // Lawn before the wall, floor behind it, and the floor's side below: behind the lawn the wall
    // goes on downwards, and behind the wall the lawn goes on into the floor. Neither is seen.
    const scene::Mesh lawn = quad({-2, 0, -1}, {-2, 0, 1}, {0, 0, 1}, {0, 0, -1});
    scene::Mesh slab = quad({0, 0, -1}, {0, 0, 1}, {2, 0, 1}, {2, 0, -1});
    add_quad(slab, {0, -1, -1}, {0, -1, 1}, {0, 0, 1}, {0, 0, -1});
    const scene::Mesh wall = quad({0, 0, -0.8F}, {0, 0, 0.8F}, {0, 1, 0.8F}, {0, 1, -0.8F});
    const scene::Scene scene = scene_of({lawn, slab, wall});
    const scene::View view = view_from({-6, 3, 0}, {0, 0, 0});
    const Truth truth = trace(scene, view);
    const double foot_px = kFocal_px * 1.6 / std::sqrt(45.0);
    EXPECT_NEAR(seen_length(scene, truth, {0, 0, -0.8F}, {0, 0, 0.8F}), foot_px, 0.01);
    expect_the_same_in_every_pose(scene, view);
}

TEST(TouchingParts, SolidsThatStandOnAndBesideEachOther) {
    const scene::Scene scene = scene_of({box({-3, -1.1F, -2}, {3, -0.7F, 2}),
                                         box({-1.3F, -0.7F, -0.6F}, {0.1F, 0.4F, 0.7F}),
                                         box({0.1F, -0.7F, -0.9F}, {1.2F, 0.7F, 0.3F}),
                                         box({-1.1F, 0.4F, -0.6F}, {0.1F, 0.9F, 0.3F})});
    expect_the_same_in_every_pose(scene, view_from({3.3, 3, 6}, {0, 0, 0}));
    expect_the_same_in_every_pose(scene, view_from({-4, 1.2, 5}, {0, 0, 0}));
}

/// Two sheets of one object, 1.5e-3 apart, and far off a triangle that makes the object large.
scene::Scene gap_scene(bool has_far_triangle) {
    scene::Mesh mesh = quad(
        {-0.05F, -0.03F, 0}, {-0.00075F, -0.03F, 0}, {-0.00075F, 0.03F, 0}, {-0.05F, 0.03F, 0});
    add_quad(
        mesh, {0.00075F, -0.03F, 0}, {0.05F, -0.03F, 0}, {0.05F, 0.03F, 0}, {0.00075F, 0.03F, 0});
    if (has_far_triangle)
        add_triangle(mesh, {-1000, -5, -1000}, {1000, -5, -1000}, {0, 900, -1000});
    return scene_of({mesh});
}

/// Visible length on the two borders of the gap.
double length_at_gap(const scene::Scene& scene, double distance) {
    const Truth truth = trace(scene, view_from(distance, 1e-3));
    return seen_length(scene, truth, {-0.00075F, -0.03F, 0}, {-0.00075F, 0.03F, 0}) +
           seen_length(scene, truth, {0.00075F, -0.03F, 0}, {0.00075F, 0.03F, 0});
}

TEST(Defect, AGapThatCanBeSeenHasBothItsBorders) {
    // 4.5 px wide, 180 px high; the object's tolerance is 2.2e-3.
    EXPECT_NEAR(length_at_gap(gap_scene(true), 0.2), 2 * 600 * 0.06 / 0.2, 0.01);
    // 1/64 px wide at a distance of 57.6.
    EXPECT_NEAR(length_at_gap(gap_scene(true), 57), 2 * 600 * 0.06 / 57, 0.01);
    EXPECT_EQ(length_at_gap(gap_scene(true), 58), 0);
    // Beyond the tolerance of a small object a gap is one at any distance.
    EXPECT_NEAR(length_at_gap(gap_scene(false), 58), 2 * 600 * 0.06 / 58, 0.01);
}

}  // namespace
}  // namespace ink::truth
