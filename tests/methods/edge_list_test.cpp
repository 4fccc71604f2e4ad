// What edge_list and edge_hash draw: widths, hidden lines, the same image by every builder.

#include <gtest/gtest.h>

#include <algorithm>

#include "catalogue/catalogue.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr std::pair<int, int> kSize_px{160, 120};

std::ptrdiff_t lines_in_row(const edge::EdgeImage& image, int y) {
    return std::count(image.row(y), image.row(y) + image.width_px(), 255);
}

class KnownEdges : public testing::TestWithParam<std::string> {};

TEST_P(KnownEdges, ContoursAreAsWideAsTheyAreAskedToBe) {
    const scene::Scene scene = scene_of({cube_mesh()});
    const scene::View face_on = view_from(scene, {0, 0, 6}, {0, 0, 0}, kSize_px);
    for (const int width_px : {1, 2, 3, 6}) {
        const core::ParamValues wide{{"width_contour_px", std::to_string(width_px)}};
        EXPECT_EQ(lines_in_row(drawn(GetParam(), wide, scene, {face_on}), 60), 2 * width_px);
    }
}

TEST_P(KnownEdges, CreasesHaveAWidthOfTheirOwn) {
    const scene::Scene scene = scene_of({cube_mesh()});
    // The edge between two sides stands upright in the middle, a contour on either hand.
    const scene::View edge_on = view_from(scene, {4.5, 0, 4.5}, {0, 0, 0}, kSize_px);
    const core::ParamValues wide{{"width_contour_px", "1"}, {"width_crease_px", "4"}};
    EXPECT_EQ(lines_in_row(drawn(GetParam(), {}, scene, {edge_on}), 60), 2 + 1 + 2);
    EXPECT_EQ(lines_in_row(drawn(GetParam(), wide, scene, {edge_on}), 60), 1 + 4 + 1);
    const core::ParamValues none{{"crease_deg", "91"}};
    EXPECT_EQ(lines_in_row(drawn(GetParam(), none, scene, {edge_on}), 60), 2 + 2);
}

TEST_P(KnownEdges, WhatStandsBehindASurfaceIsNotDrawn) {
    scene::Scene scene = scene_of({floor_mesh(4), cube_mesh()});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {0, -3, 0});
    const scene::View above = view_from(scene, {0.5, 8, 0.5}, {0, 0, 0}, kSize_px);
    const auto both = drawn(GetParam(), {}, scene, {above});
    scene.instances.pop_back();
    EXPECT_EQ(both, drawn(GetParam(), {}, scene, {above}));
}

INSTANTIATE_TEST_SUITE_P(Both,
                         KnownEdges,
                         testing::Values("edge_list", "edge_hash"),
                         [](const auto& method) { return method.param; });

TEST(EdgeList, EveryBuilderGivesTheSameImage) {
    for (const char* name : {"rocket", "cone", "soup"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        const scene::View view{scene.cameras[0], kSize_px.first, kSize_px.second};
        const auto image = drawn("edge_list", {{"builder", "hash"}}, scene, {view});
        EXPECT_EQ(drawn("edge_list", {{"builder", "temp_list"}}, scene, {view}), image) << name;
        if (scene.name == "soup") continue;  // nine thousand triangles
        EXPECT_EQ(drawn("edge_list", {{"builder", "all_pairs"}}, scene, {view}), image) << name;
    }
}

}  // namespace
}  // namespace ink::methods
