#include "inspect/explain.h"

#include <gtest/gtest.h>

#include "harness/suite/suite.h"
#include "methods/method_configs.h"

namespace ink::inspect {
namespace {

TEST(Explain, TextHasAHeadingForEachPart) {
    const auto torus = harness::load_scenes({"torus"}, {}).front();
    const Explanation explained = explain(torus, methods::make_configs("mote4,auto", {}), 40);
    ASSERT_EQ(explained.methods.size(), 2U);
    ASSERT_FALSE(explained.methods[1].plan.empty());
    const std::string text = as_text(explained);
    for (const std::string& part : {std::string("torus: its scene statistics"),
                                    std::string("mote4: what it left undone in the first view"),
                                    std::string("auto: what it chose, and why"),
                                    explained.methods[1].plan.front().why})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(Explain, CountsWhatAMethodLeftUndone) {
    const auto torus = harness::load_scenes({"torus"}, {}).front();
    const Explanation explained = explain(torus, methods::make_configs("mote4", {}), 40);
    const auto& skips = explained.methods.front().skips;
    const auto count = [&](raster::Skip skip) { return skips[static_cast<std::size_t>(skip)]; };
    const raster::SkipCount backs = count(raster::Skip::back_face_culling);
    EXPECT_GT(backs.skipped, backs.of / 5) << "half of a torus is turned away";
    EXPECT_LT(backs.skipped, backs.of);
    EXPECT_GT(count(raster::Skip::empty_tiles).skipped, 0U) << "there is sky";
    EXPECT_EQ(count(raster::Skip::temporal_reuse).skipped, 0U) << "it is the first frame";
}

}  // namespace
}  // namespace ink::inspect
