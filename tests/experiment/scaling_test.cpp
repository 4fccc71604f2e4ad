#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiment/summary/scaling_steps.h"
#include "report/scaling_chart.h"
#include "tests/harness/skipping_method.h"
#include "tests/report/markup.h"

namespace ink::experiment {
namespace {

using testing::HasSubstr;
using testing::Not;

studies::ScalingPoint point(const std::string& method, double x, std::int64_t ns) {
    studies::ScalingPoint point;
    point.method = method;
    point.x = x;
    point.draw_ns_min = ns;
    return point;
}

TEST(ScalingSteps, AreTheSlopesBetweenNeighbours) {
    // Out of order; 8 times as long for twice as many, then ten times for ten times as many.
    const std::vector<ScalingStep> steps = scaling_steps(
        {point("a", 2000, 80'000'000), point("a", 100, 1'000'000), point("a", 1000, 10'000'000)});
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[0].from, 100);
    EXPECT_EQ(steps[0].to, 1000);
    EXPECT_NEAR(steps[0].exponent, 1, 1e-12);
    EXPECT_NEAR(steps[1].exponent, 3, 1e-12);
    // Ten per cent at either end, over a decade.
    EXPECT_NEAR(steps[0].tolerance, std::log10(1.1 * 1.1), 1e-12);
    EXPECT_FALSE(steps[0].is_worse_than_linear());
    EXPECT_TRUE(steps[1].is_worse_than_linear());
}

TEST(ScalingSteps, LeaveOutPointsWithoutATime) {
    const std::vector<ScalingStep> steps =
        scaling_steps({point("a", 1, 100), point("a", 2, 0), point("a", 4, 400)});
    ASSERT_EQ(steps.size(), 1U);
    EXPECT_EQ(steps[0].to, 4);
    EXPECT_NEAR(steps[0].exponent, 1, 1e-12);
}

TEST(TimeSphere, AMethodThatFailsHasAPointThatSaysWhy) {
    harness::SkipScript script;
    script.failure = "out of ink";
    const auto info = harness::skipping_info(script);
    const auto points = studies::time_sphere({{&info, {}}}, 0, {});
    ASSERT_EQ(points.size(), 1U) << "the smallest sphere lies on one axis";
    EXPECT_EQ(points[0].status, "failed: out of ink");
    EXPECT_EQ(points[0].triangles, 120);
    EXPECT_FALSE(points[0].is_timed());
}

TEST(ScalingSteps, TolerateWhatRoundsOfOnePointDifferBy) {
    std::vector<studies::ScalingPoint> points = {point("a", 1, 100), point("a", 10, 1500)};
    EXPECT_TRUE(scaling_steps(points).front().is_worse_than_linear());
    points[0].noise = 0.5;
    const ScalingStep step = scaling_steps(points).front();
    EXPECT_NEAR(step.tolerance, std::log10(1.5 * 1.1), 1e-12);
    EXPECT_FALSE(step.is_worse_than_linear());
}

TEST(ScalingSteps, KeepMethodsAndAxesApart) {
    std::vector<studies::ScalingPoint> points = {
        point("a", 1, 10), point("b", 1, 10), point("a", 2, 10), point("b", 2, 20)};
    points.push_back(point("a", 4, 40));
    points.back().axis = studies::ScalingAxis::pixels;
    const std::vector<ScalingStep> steps = scaling_steps(points);
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[0].exponent, 0);
    EXPECT_EQ(steps[1].method, "b");
    EXPECT_NEAR(steps[1].exponent, 1, 1e-12);
    EXPECT_TRUE(scaling_steps({point("a", 1, 10), point("a", 1, 20)}).empty());
    EXPECT_TRUE(scaling_steps({}).empty());
}

TEST(ScalingSentence, NamesTheSteepestStepAndTheTolerance) {
    const auto sentence = [](std::int64_t last_ns) {
        return scaling_sentence(
            scaling_steps({point("a", 100, 1'000'000), point("a", 1000, last_ns)}));
    };
    EXPECT_EQ(sentence(5'000'000),
              "No step is worse than linear. The steepest: a from 100 to 1000 triangles, exponent "
              "0.70 (noise alone may make 1.08).");
    EXPECT_EQ(sentence(20'000'000),
              "Worse than linear in 1 of 1 steps. The steepest: a from 100 to 1000 triangles, "
              "exponent 1.30 (noise alone may make 1.08).");
    EXPECT_EQ(scaling_sentence({}), "");
}

TEST(FormatScalingX, HasThreeDigitsThatCount) {
    EXPECT_EQ(format_scaling_x(studies::ScalingAxis::triangles, 120), "120");
    EXPECT_EQ(format_scaling_x(studies::ScalingAxis::triangles, 10200), "10.2 k");
    EXPECT_EQ(format_scaling_x(studies::ScalingAxis::pixels, 33177600), "33.2 M");
    EXPECT_EQ(format_scaling_x(studies::ScalingAxis::covered, 0.004), "0.4 %");
}

TEST(ScalingChart, HasALinePerMethodAndAGuide) {
    const std::string svg =
        report::scaling_chart(
            studies::ScalingAxis::triangles,
            {point("a<b", 100, 2'000'000), point("a<b", 1000, 4'000'000), point("c", 100, 900)})
            .inline_element("cost");
    EXPECT_EQ(report::nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(">a&lt;b</text>"));
    EXPECT_THAT(svg, HasSubstr(">c</text>"));
    EXPECT_THAT(svg, HasSubstr(">linear</text>"));
    EXPECT_THAT(svg, HasSubstr("triangles of the sphere, logarithmic"));
    EXPECT_THAT(svg, HasSubstr("<title>c: 100 triangles, 0.9 µs</title>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(
        report::scaling_chart(studies::ScalingAxis::pixels, {point("a", 1, 1)}).inline_element("x"),
        HasSubstr("No method was timed here."));
}

}  // namespace
}  // namespace ink::experiment
