#include "truth/limits.h"

#include <string>

#include "tests/truth/shapes.h"
#include "truth/model.h"

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
