// Channel planes against the method that rasterizes: the truth's triangles and the scene's depth
// and normals give the very buffer that mote4 and mote16 filter.

#include "linear_code/channel_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "catalogue/catalogue.h"
#include "harness/cells/cell.h"
#include "methods/registry.h"

namespace ink::linear_code {
namespace {

struct Seen {
    harness::SceneViews scene_views;
    truth::Layers layers;
};

Seen see(const std::string& name) {
    harness::ViewRequest request;
    request.width_px = 320;
    request.height_px = 180;
    Seen seen{harness::make_scene_views(catalogue::make_catalogue_scene(name), request), {}};
    truth::SceneModel model(seen.scene_views.scene, {});
    seen.layers = harness::trace_view(model, seen.scene_views.views.front(), {}).traced.layers;
    return seen;
}

std::unique_ptr<method::Method> prepared(const Seen& seen,
                                         const std::string& name,
                                         const core::ParamValues& settings) {
    auto method = methods::find_method(name).make(settings);
    method->prepare(seen.scene_views.scene);
    method->pose(seen.scene_views.scene);
    return method;
}

/// Pixels of one code against the other's: how many differ, and how many by more than one.
struct Difference {
    int any = 0;
    int more_than_one = 0;
};

Difference difference(const Seen& seen, const core::ParamValues& settings) {
    const auto method = prepared(seen, "mote4", settings);
    const scene::View& view = seen.scene_views.views.front();
    const auto code = method->code();
    const ChannelSource source(seen.scene_views.scene, *code);
    const auto codes = codes_of(source.planes(view, seen.layers.triangle), *code);
    const core::Image<glm::u8vec3> packed = method->layers({view, 1}).front().rgb;
    Difference difference;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const int apart = std::abs(codes.data()[i] - packed.data()[i].x);
        const int off = code->wraps ? std::min(apart, 256 - apart) : apart;
        difference.any += off > 0;
        difference.more_than_one += off > 1;
    }
    return difference;
}

TEST(ChannelPlanes, HoldTheMethodsBuffer) {
    constexpr int kPixels = 320 * 180;
    for (const char* scene : {"cube", "torus", "teapot", "room"}) {
        const Seen seen = see(scene);
        for (const core::ParamValues& settings :
             {core::ParamValues{},
              {{"range_depth", "120"}, {"range_nx", "45"}, {"depth_sign", "far_high"}},
              {{"packing", "pixel"}, {"interpolation", "perspective"}, {"normals", "facet"}},
              {{"overflow", "wrap"}, {"range_nx", "200"}, {"sky", "77"}}}) {
            const Difference off = difference(seen, settings);
            EXPECT_LE(off.any, kPixels / 100) << scene;
            EXPECT_LE(off.more_than_one, kPixels / 1000) << scene;
        }
    }
}

TEST(ChannelPlanes, FilteredAreTheMethodsImage) {
    const Seen seen = see("torus");
    const scene::View& view = seen.scene_views.views.front();
    const auto method = prepared(seen, "mote16", {});
    const auto code = method->code();
    const ChannelSource source(seen.scene_views.scene, *code);
    const auto edge_responses = responses_of(source.planes(view, seen.layers.triangle), *code);
    edge::EdgeImage drawn(view.width_px, view.height_px);
    method->draw({view, 1}, drawn);
    const int threshold = 128;
    int differ = 0;
    for (int y = 1; y + 1 < view.height_px; ++y) {
        for (int x = 1; x + 1 < view.width_px; ++x)
            differ += (edge_responses.at(x, y) >= threshold) != (drawn.at(x, y) >= threshold);
    }
    EXPECT_LE(differ, view.width_px * view.height_px / 500);
}

TEST(ChannelPlanes, LieWithinZeroAndOneAndAreZeroOnSky) {
    const Seen seen = see("torus");
    const scene::View& view = seen.scene_views.views.front();
    const ChannelSource source(seen.scene_views.scene, *prepared(seen, "mote4", {})->code());
    const ChannelPlanes planes = source.planes(view, seen.layers.triangle);
    int sky = 0;
    for (std::size_t i = 0; i < planes.is_sky.size(); ++i) {
        const bool is_sky = seen.layers.triangle.data()[i] == truth::kNoTriangle;
        ASSERT_EQ(planes.is_sky.data()[i], is_sky ? 1 : 0);
        sky += is_sky;
        for (const auto& channel : planes.channels) {
            ASSERT_GE(channel.data()[i], 0.0F);
            ASSERT_LE(channel.data()[i], is_sky ? 0.0F : 1.0F);
        }
    }
    EXPECT_GT(sky, 1000);
}

TEST(ChannelPlanes, OfAnEmptyImageAreEmpty) {
    const ChannelPlanes nothing;
    EXPECT_TRUE(codes_of(nothing, {}).is_empty());
    EXPECT_TRUE(responses_of(nothing, {}).is_empty());
}

}  // namespace
}  // namespace ink::linear_code
