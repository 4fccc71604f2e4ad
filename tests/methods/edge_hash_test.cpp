#include "methods/edge_hash/edge_hash.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr std::pair<int, int> kSize_px{160, 120};

void pose(EdgeHash& method, const scene::Scene& scene) {
    method.prepare(scene);
    method.pose(scene);
}

edge::EdgeImage image(EdgeHash& method, const scene::View& view) {
    return image_by(method, {view});
}

TEST(EdgeHash, AStaleEyeIsThatOfTheLastViewUnlikeThisOne) {
    const scene::Scene scene = scene_of({catalogue::make_icosphere(1, 3)});
    const scene::View here = view_from(scene, {0, 1, 5}, {0, 0, 0}, kSize_px);
    const scene::View there = view_from(scene, {3, 1, 4}, {0, 0, 0}, kSize_px);
    EdgeHash::Params old;
    old.eye = EdgeHash::Eye::stale;
    EdgeHash exact{EdgeHash::Params{}}, stale(old);
    pose(exact, scene);
    pose(stale, scene);
    EXPECT_EQ(image(stale, here), image(exact, here));  // there was none before
    EXPECT_EQ(image(stale, here), image(exact, here));
    const auto late = image(stale, there);
    EXPECT_NE(late, image(exact, there));
    EXPECT_EQ(image(stale, there), late);  // the same view again
    pose(stale, scene);
    EXPECT_EQ(image(stale, there), image(exact, there));
}

}  // namespace
}  // namespace ink::methods
