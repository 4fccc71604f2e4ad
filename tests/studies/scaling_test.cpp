#include "studies/scaling.h"

#include <gtest/gtest.h>

#include "tests/harness/skipping_method.h"

namespace ink::studies {
namespace {

TEST(TimeSphere, AMethodThatFailsHasAPointThatSaysWhy) {
    harness::SkipScript script;
    script.failure = "out of ink";
    const auto info = harness::skipping_info(script);
    const auto points = time_sphere({{&info, {}}}, 0, {});
    ASSERT_EQ(points.size(), 1U) << "the smallest sphere lies on one axis";
    EXPECT_EQ(points[0].status, "failed: out of ink");
    EXPECT_EQ(points[0].triangles, 120);
    EXPECT_FALSE(points[0].is_timed());
}

}  // namespace
}  // namespace ink::studies
