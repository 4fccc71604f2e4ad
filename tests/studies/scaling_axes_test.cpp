#include "studies/scaling_axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/axis_rows.h"
#include "tests/harness/made_up_method.h"

namespace ink::studies {
namespace {

using testing::ElementsAre;

TEST(ScalingAxes, GrowInTrianglesPixelsAndWhatIsCovered) {
    const std::vector<Axis> axes = scaling_axes();
    ASSERT_EQ(axes.size(), 3U);
    EXPECT_EQ(axes[0].values.front(), 120);
    EXPECT_GE(axes[0].values.back(), 1e6);
    EXPECT_THAT(axes[1].values,
                ElementsAre(640 * 480, 1280 * 720, 1920 * 1080, 3840 * 2160, 7680 * 4320));
    EXPECT_THAT(axes[2].values, ElementsAre(0.001, 0.004, 0.016, 0.064, 0.25, 1));
    for (const Axis& axis : axes) {
        const Case one = axis.cases(axis.values.front(), {}).front();
        EXPECT_EQ(one.scene_views.scene.name, "scaling_sphere");
    }
    const Case large = axes[1].cases(axes[1].values.back(), {}).front();
    EXPECT_EQ(large.scene_views.views.front().width_px, 7680);
    EXPECT_EQ(large.scene_views.views.front().camera.name, "pixels=33177600");
}

TEST(ScalingAxes, AreTimedAndNotScored) {
    harness::Script script;
    const auto info = harness::made_up_info(script);
    const Axis axis = scaling_axes().front();
    const auto rows =
        axis_rows(axis, axis.cases(axis.values.front(), {}).front(), {{&info, {}}}, {});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].row.status, "ok");
    EXPECT_EQ(rows[0].row.triangles, 120);
    EXPECT_EQ(rows[0].row.axis, "triangles");
    EXPECT_EQ(rows[0].row.value, 120);
    EXPECT_EQ(rows[0].row.draw_n, axis.repetitions) << "it takes no time";
    EXPECT_FALSE(rows[0].row.f_2px);
}

TEST(ScalingAxes, AMethodThatFailsHasARowThatSaysWhy) {
    harness::Script script;
    script.failure = "out of ink";
    const auto info = harness::made_up_info(script);
    const Axis axis = scaling_axes().front();
    const auto rows =
        axis_rows(axis, axis.cases(axis.values.front(), {}).front(), {{&info, {}}}, {});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].row.status, "failed: out of ink");
    EXPECT_FALSE(rows[0].row.draw_ns_min);
}

}  // namespace
}  // namespace ink::studies
