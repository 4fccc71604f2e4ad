#include "methods/edge_hash/edge_hash.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr std::pair<int, int> kSize_px{160, 120};

EdgeHash posed(const scene::Scene& scene, const EdgeHash::Params& params = {}) {
    EdgeHash method(params);
    method.prepare(scene);
    method.pose(scene);
    return method;
}

edge::EdgeImage image(EdgeHash& method, const scene::View& view) {
    return image_by(method, {view});
}

TEST(EdgeHash, AStaleEyeIsThatOfTheLastViewUnlikeThisOne) {
    const scene::Scene scene = scene_of({catalogue::make_icosphere(1, 3)});
    const scene::View here = view_from(scene, {0, 1, 5}, {0, 0, 0}, kSize_px);
    const scene::View there = view_from(scene, {3, 1, 4}, {0, 0, 0}, kSize_px);
    EdgeHash exact = posed(scene);
    EdgeHash::Params old;
    old.eye = EdgeHash::Eye::stale;
    EdgeHash stale = posed(scene, old);
    EXPECT_EQ(image(stale, here), image(exact, here));  // there was none before
    EXPECT_EQ(image(stale, here), image(exact, here));
    const auto late = image(stale, there);
    EXPECT_NE(late, image(exact, there));
    EXPECT_EQ(image(stale, there), late);  // the same view again
    stale.prepare(scene);
    stale.pose(scene);
    EXPECT_EQ(image(stale, there), image(exact, there));
}

std::size_t count(const DebugImage& image, const glm::u8vec3& color) {
    return static_cast<std::size_t>(
        std::count(image.rgb.data(), image.rgb.data() + image.rgb.size(), color));
}

TEST(EdgeHash, ItsDebugImageHasAColorForEachKind) {
    const scene::Scene scene = cube_on_floor();
    const scene::View view = view_from(scene, {4, 3, 6}, {0, 0, 0}, kSize_px);
    EdgeHash method = posed(scene);
    const DebugImage image = method.debug_image({view});
    EXPECT_EQ(image.counts.contours, 6U);
    EXPECT_EQ(image.counts.creases, 6U);
    EXPECT_EQ(image.counts.boundary, 4U);
    EXPECT_EQ(image.counts.models.edges, 18U + 5);
    EXPECT_GT(count(image, {0, 0, 0}), 100U);
    EXPECT_GT(count(image, {255, 255, 255}), 50U);
    EXPECT_GT(count(image, {255, 0, 0}), 100U);
}

TEST(EdgeHash, ItsDebugImageOfAClosedSolidHasNoRedAndOfNothingIsPaper) {
    const scene::View view = view_from(cube_on_floor(), {4, 3, 6}, {0, 0, 0}, kSize_px);
    const DebugImage solid = posed(scene_of({cube_mesh()})).debug_image({view});
    EXPECT_EQ(solid.counts.boundary, 0U);
    EXPECT_EQ(count(solid, {255, 0, 0}), 0U);
    const DebugImage image = posed({}).debug_image({view});
    EXPECT_EQ(count(image, image.rgb.at(0, 0)), image.rgb.size());
    EXPECT_EQ(image.counts.contours + image.counts.creases + image.counts.boundary, 0U);
}

}  // namespace
}  // namespace ink::methods
