#include "inspect/explain.h"

#include <gtest/gtest.h>

#include "methods/method_configs.h"

namespace ink::inspect {
namespace {

TEST(Explain, TextHasAHeadingForEachPart) {
    const harness::SceneViews scene_views =
        harness::make_scene_views(harness::load_scene("torus"), {});
    const Explanation torus = explain(scene_views, methods::make_configs("auto", {}).front(), 40);
    EXPECT_EQ(torus.views.size(), scene_views.views.size());
    ASSERT_FALSE(torus.plan.empty());
    const std::string text = as_text(torus, true);
    for (const std::string& part : {std::string("torus: its scene statistics"),
                                    std::string("torus, seen from "),
                                    std::string("auto: what it chose, and why"),
                                    torus.plan.front().why})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace ink::inspect
