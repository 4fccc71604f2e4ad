#include "inspect/explain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "methods/method_configs.h"

namespace ink::inspect {
namespace {

/// What `method` with `settings` is told on a built-in scene.
MethodExplanation explained(const std::string& scene,
                            const std::string& method,
                            const std::vector<std::string>& settings = {}) {
    const harness::SceneViews scene_views =
        harness::make_scene_views(harness::load_scene(scene), {});
    return explain(scene_views, methods::make_configs(method, settings), 40).methods.front();
}

const Optimisation& find(const std::vector<Optimisation>& optimisations, const std::string& what) {
    return *std::find_if(
        optimisations.begin(), optimisations.end(), [&](const auto& o) { return o.what == what; });
}

TEST(Explain, ListsEverySkipForEveryMethod) {
    const harness::SceneViews scene_views =
        harness::make_scene_views(harness::load_scene("cube"), {});
    const auto configs = methods::make_configs("", {});
    const Explanation all = explain(scene_views, configs, 40);
    ASSERT_EQ(all.methods.size(), configs.size());
    EXPECT_EQ(all.views.size(), scene_views.views.size());
    for (const MethodExplanation& method : all.methods) {
        ASSERT_EQ(method.skips.size(), raster::kSkipCount) << method.method;
        for (const Optimisation& skip : method.skips)
            EXPECT_FALSE(skip.why.empty()) << method.method << ", " << skip.what;
    }
}

TEST(Explain, FlatTilesNeedTwoClippedBits) {
    EXPECT_TRUE(find(explained("cube", "mote4").skips, "flat_tiles").may);
    const auto refused = explained("cube", "mote4", {"clip_bits=1"});
    EXPECT_FALSE(find(refused.skips, "flat_tiles").may);
    EXPECT_NE(find(refused.skips, "flat_tiles").why.find("clip_bits = 1"), std::string::npos);
}

TEST(Explain, FlatTilesNeedACodeThatIsLinearOnTheScreen) {
    for (const char* setting : {"interpolation=perspective",
                                "packing=pixel",
                                "response=wrap",
                                "quantise=each",
                                "fatten=true"}) {
        EXPECT_FALSE(find(explained("cube", "mote4", {setting}).skips, "flat_tiles").may)
            << setting;
    }
    EXPECT_FALSE(find(explained("cube", "decaudin").skips, "flat_tiles").may);
}

TEST(Explain, BackFaceCullingNeedsWatertightComponents) {
    EXPECT_TRUE(find(explained("cube", "mote4").skips, "back_face_culling").may);
    EXPECT_FALSE(find(explained("tiles", "mote4").skips, "back_face_culling").may);
}

TEST(Explain, AttributesAreLeftOutWhereTheirWeightIsZero) {
    EXPECT_FALSE(find(explained("cube", "mote4").skips, "attributes").may);
    const auto without = explained("cube", "mote4", {"range_ny=0"});
    EXPECT_TRUE(find(without.skips, "attributes").may);
    EXPECT_NE(find(without.skips, "attributes").why.find("ny"), std::string::npos);
}

TEST(Explain, NormalsTellNothingWithoutCreasesAndCrossings) {
    EXPECT_TRUE(find(explained("torus", "mote4").channels, "nx").may);
    EXPECT_FALSE(find(explained("cube", "mote4").channels, "nx").may);
    EXPECT_FALSE(find(explained("torus", "mote4").channels, "depth").may);
    EXPECT_TRUE(explained("torus", "decaudin").channels.empty());
}

TEST(Explain, OnlyAutoHasAPlan) {
    EXPECT_FALSE(explained("torus", "auto").plan.empty());
    EXPECT_TRUE(explained("torus", "mote4").plan.empty());
}

TEST(Explain, TextHasAHeadingForEachPart) {
    const harness::SceneViews scene_views =
        harness::make_scene_views(harness::load_scene("torus"), {});
    const std::string text =
        as_text(explain(scene_views, methods::make_configs("auto,mote4", {}), 40), true);
    for (const char* part : {"torus: its scene statistics",
                             "torus, seen from ",
                             "auto: what it may leave out",
                             "mote4: channels that show no line here",
                             "auto: what it chose, and why"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

}  // namespace
}  // namespace ink::inspect
