
#include <numbers>

#include "tests/truth/shapes.h"
#include "truth/crossings/crossings.h"
#include "truth/model.h"

namespace ink::truth {
namespace {

constexpr double kPx = 0.01;

/// How many crossings of two meshes in one object or in two are no slits at this weld tolerance.
std::size_t kept(const std::vector<scene::Mesh>& meshes, double tolerance, bool one_object = true) {
    const scene::Topology topology =
        scene::weld(one_object ? scene_of({joined(meshes)}) : scene_of(meshes));
    auto crossings = find_crossings(topology, {}).segments;
    EXPECT_GT(crossings.size(), 0U);
    const std::vector<double> tolerances(meshes.size(), tolerance);
    const auto continuations =
        find_continuations(topology, {tolerances, 40 * std::numbers::pi / 180, 1});
    mark_slit_crossings(topology, continuations, tolerances, crossings);
    return static_cast<std::size_t>(
        std::count_if(crossings.begin(), crossings.end(), [](const Crossing& crossing) {
            return std::isinf(crossing.slit_world);
        }));
}

scene::Mesh triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    scene::Mesh mesh;
    add_triangle(mesh, a, b, c);
    return mesh;
}

/// A triangle with a side on x = `border` that runs to x = `tip` there, at height `slope` times the
/// distance from x = 0.
scene::Mesh leaf(float border, float tip, float slope) {
    return triangle(
        {border, -1, slope * border}, {tip, 0, slope * tip}, {border, 1, slope * border});
}

TEST(SlitCrossings, PiecesThatOverlapByLessThanTheToleranceAreOneSurface) {
    // Both leaves cross in x = z = 0, which each passes by 1e-3.
    const scene::Mesh left = leaf(0.001F, -2, 0.1F), right = leaf(-0.001F, 2, -0.1F);
    EXPECT_EQ(kept({left, right}, 2e-3), 0U);
    EXPECT_EQ(kept({left, right}, 2e-4), 1U) << "wider than the tolerance";
    EXPECT_EQ(kept({left, right}, 2e-3, false), 1U) << "two objects";
}

TEST(SlitCrossings, PiecesThatOverlapByMoreAndMoreAreOneSurfaceForAPart) {
    // They cross in x = z = 0. Each passes that by 0.0005 at y = -1 and by 0.0085 at y = 1.
    scene::Mesh both = triangle({0.0005F, -1, 0.00005F}, {-2, 0, -0.2F}, {0.0085F, 1, 0.00085F});
    add_triangle(both, {-0.0005F, -1, 0.00005F}, {2, 0, -0.2F}, {-0.0085F, 1, 0.00085F});
    const scene::Topology topology = scene::weld(scene_of({both}));
    auto crossings = find_crossings(topology, {}).segments;
    ASSERT_EQ(crossings.size(), 1U);
    const std::vector<double> tolerances(1, 1e-3);
    const auto continuations =
        find_continuations(topology, {tolerances, 40 * std::numbers::pi / 180, 1});
    mark_slit_crossings(topology, continuations, tolerances, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    const bool is_first = !std::isinf(crossings[0].slit_world);
    const Crossing& slit = crossings[is_first ? 0 : 1];
    const Crossing& rest = crossings[is_first ? 1 : 0];
    EXPECT_TRUE(std::isinf(rest.slit_world));
    // Two tolerances from a border at y = -0.625.
    EXPECT_NEAR(slit.slit_world, 2e-3, 1e-6);
    EXPECT_NEAR(std::max(slit.begin_world.y, slit.end_world.y), -0.625, 0.01);
    EXPECT_NEAR(std::min(rest.begin_world.y, rest.end_world.y), -0.625, 0.01);
}

TEST(SlitCrossings, ACreaseIsKept) {
    // 2 atan 0.5 = 53 degrees.
    EXPECT_EQ(kept({leaf(0.001F, -2, 0.5F), leaf(-0.001F, 2, -0.5F)}, 2e-3), 1U);
}

TEST(SlitCrossings, LeavesOfABookAreKept) {
    // Both lie to the right of their borders, 11 degrees apart: nothing goes on beyond those.
    EXPECT_EQ(kept({leaf(-0.001F, 2, 0.1F), leaf(-0.001F, 2, -0.1F)}, 2e-3), 1U);
}

TEST(SlitCrossings, ACrossingFromBorderToBorderIsKept) {
    // Turned by 10 degrees to either side round the line x = 0, z = 0, in which they cross from
    // (0, -1, 0) to (0, 1, 0): both its ends lie on borders of both.
    const auto c = static_cast<float>(std::cos(std::numbers::pi / 18));
    const auto s = static_cast<float>(std::sin(std::numbers::pi / 18));
    const scene::Mesh first = triangle({-c, -1, -s}, {c, -1, s}, {0, 1, 0});
    const scene::Mesh second = triangle({-c, -1, s}, {c, -1, -s}, {0, 1, 0});
    EXPECT_EQ(kept({first, second}, 1e-5), 1U);

    scene::Mesh both = first;
    add_triangle(both, {-c, -1, s}, {c, -1, -s}, {0, 1, 0});
    const Truth truth = trace(scene_of({both}), view_from(6));
    EXPECT_NEAR(lengths(truth)[LineClass::intersection], 200, kPx);
}

}  // namespace
}  // namespace ink::truth
