#include "truth/limits.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/truth/shapes.h"
#include "truth/model.h"
#include "truth/pilots.h"

namespace ink::truth {
namespace {

/// `n` needles that stand apart, each with three boundaries.
scene::Scene needles(int n) {
    scene::Mesh mesh;
    for (int i = 0; i < n; ++i) {
        const float x = 0.02F * static_cast<float>(i % 100) - 1;
        const float y = 0.02F * static_cast<float>(i / 100) - 1;
        add_triangle(mesh, {x, y, 0}, {x + 0.01F, y, 0}, {x, y + 0.01F, 0});
    }
    return scene_of({mesh});
}

std::string refusal(const scene::Scene& scene, const TruthOptions& options) {
    try {
        static_cast<void>(trace_truth(scene, view_from(4), options));
    } catch (const TooLarge& reason) {
        return reason.what();
    }
    return "";
}

TEST(Limits, DefaultsLetOrdinaryScenesThrough) {
    EXPECT_EQ(refusal(needles(1000), {}), "");
}

TEST(Limits, RefusalIsTheSameForEveryThreadCountAndSaysTheCounts) {
    TruthOptions options;
    options.limits.rays = 5000;
    const std::string one = refusal(needles(2000), options);
    EXPECT_NE(one.find("6000 lines"), std::string::npos) << one;
    EXPECT_NE(one.find("5000 rays"), std::string::npos) << one;
    for (const int threads : {2, 3, 4}) {
        options.threads = threads;
        EXPECT_EQ(refusal(needles(2000), options), one) << threads;
    }
}

TEST(Limits, TwiceTheLimitIsRefusedAfterAShareOfTheWork) {
    const scene::Scene scene = needles(40000);
    TruthOptions options;
    std::size_t most_done = 0, parts = 0;
    options.progress = [&](std::size_t done, std::size_t total) {
        most_done = std::max(most_done, done);
        parts = total;
    };
    const Truth truth = trace_truth(scene, view_from(4), options);
    EXPECT_EQ(most_done, parts);
    options.limits.rays = truth.counts.rays / 2;
    most_done = 0;
    EXPECT_NE(refusal(scene, options), "");
    EXPECT_LT(most_done, parts / 4);
    options.limits.rays = truth.counts.rays;
    EXPECT_EQ(refusal(scene, options), "") << "what stays within the limit is not refused";
}

TEST(Pilots, SayWhatAllSurelyCost) {
    const auto even = [](std::size_t) { return 10; };
    EXPECT_DOUBLE_EQ(least_total(6400, 64, even), 0.9 * 64000);
    EXPECT_EQ(least_total(15 * 64, 64, even), 0) << "too few";
    const auto one_heavy = [](std::size_t i) { return i == 0 ? 1000000 : 0; };
    EXPECT_EQ(least_total(6400, 64, one_heavy), 0) << "one heavy task says nothing of the others";
}

TEST(Pilots, CallEveryTaskOnceInRounds) {
    for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
        std::vector<int> calls(count);
        EXPECT_TRUE(run_pilots_first(
            count, 1, [&](std::size_t i) { ++calls[i]; }, [](std::size_t) { return false; }));
        EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), std::ptrdiff_t(count)) << count;
        std::size_t done = 0;
        EXPECT_FALSE(run_pilots_first(
            count,
            1,
            [&](std::size_t i) {
                EXPECT_EQ(i % 16, 0U);
                ++done;
            },
            [](std::size_t stride) { return stride == 16; }));
        EXPECT_EQ(done, (count + 15) / 16) << count;
    }
}

TEST(Limits, HoldExactlyWhereTheCountsAre) {
    const scene::Scene scene = needles(500);
    const Truth truth = trace(scene, view_from(4));
    // Boundaries before the sky: one more ray a curve, after the lines, says so.
    const std::size_t rays = truth.counts.rays - truth.curves.size();
    ASSERT_EQ(truth.curves.size(), 1500U);
    TruthOptions options;
    options.limits.rays = rays;
    options.limits.samples = truth.counts.samples;
    EXPECT_EQ(refusal(scene, options), "");
    options.limits.rays = rays - 1;
    EXPECT_NE(refusal(scene, options), "");
    options.limits.rays = rays;
    options.limits.samples = truth.counts.samples - 1;
    EXPECT_NE(refusal(scene, options), "");
}

TEST(Limits, MemoryIsReckonedBeforeAnyWork) {
    TruthOptions options;
    options.limits.memory_bytes = memory_estimate(needles(500), 1500);
    EXPECT_EQ(refusal(needles(500), options), "");
    --options.limits.memory_bytes;
    const std::string reason = refusal(needles(500), options);
    EXPECT_NE(reason.find("500 triangles and 1500 vertices"), std::string::npos) << reason;
    EXPECT_THROW(static_cast<void>(build_model(needles(500), options)), TooLarge);
}

TEST(Limits, VerticesAtOnePlaceCountOnce) {
    // A closed box as a soup: 36 corners at 8 places.
    scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    ASSERT_EQ(scene.meshes[0].positions.size(), 36U);
    TruthOptions options;
    options.limits.memory_bytes = memory_estimate(scene, 8);
    EXPECT_EQ(refusal(scene, options), "");
    options.limits.memory_bytes -= 1;
    EXPECT_NE(refusal(scene, options), "");
}

TEST(Limits, ProgressReachesItsTotalOnOneThread) {
    std::size_t last = 0, total = 0, calls = 0;
    TruthOptions options;
    options.progress = [&](std::size_t done, std::size_t of) {
        EXPECT_GT(done, last);
        last = done;
        total = of;
        ++calls;
    };
    EXPECT_EQ(refusal(needles(1000), options), "");
    EXPECT_EQ(last, total);
    EXPECT_EQ(calls, total);
    EXPECT_GT(calls, 10U);
}

}  // namespace
}  // namespace ink::truth
