#include "linear_code/linear_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "catalogue/catalogue.h"
#include "harness/cell.h"
#include "methods/registry.h"

namespace ink::linear_code {
namespace {

/// `count` truth pixels that one stencil each would find.
void add_truth(LinearStencils& stencils, int count, const StencilVector& v) {
    for (int i = 0; i < count; ++i)
        stencils.add_truth_pixel({v});
}

void add_far(LinearStencils& stencils, int count, const StencilVector& v) {
    for (int i = 0; i < count; ++i)
        stencils.add_far_pixel(v);
}

WeightDomain up_to(double most_sum) {
    return {.is_signed = false, .most_sum = most_sum};
}

LinearBound tight_bound(const LinearStencils& stencils) {
    return linear_bound(stencils, {.gap = 0.001});
}

/// F of `found` of 30 truth pixels with `positives` far ones: the formula, written down anew.
double f_of(double found, double positives) {
    return 2 * found / (found + 30 + 0.25 * positives);
}

TEST(LinearBound, OfAStepThatStandsAboveTheNoiseIsOne) {
    LinearStencils stencils(up_to(10));
    add_truth(stencils, 30, {1, 0, 0, 0});
    add_far(stencils, 500, {0.5F, 0, 0, 0});
    const LinearBound bound = tight_bound(stencils);
    EXPECT_EQ(bound.f_found, 1);
    EXPECT_EQ(bound.f_upper, 1);
    EXPECT_GE(bound.weights[0], 1);
    EXPECT_LT(bound.weights[0], 2);
}

TEST(LinearBound, GivesUpALineThatLooksLikeNoise) {
    LinearStencils stencils(up_to(10));
    add_truth(stencils, 10, {1, 0, 0, 0});
    add_truth(stencils, 20, {0, 1, 0, 0});
    add_far(stencils, 100, {1.01F, 0, 0, 0});
    // All lines and all noise would be 2 * 30 / (30 + 30 + 25).
    ASSERT_LT(f_of(30, 100), f_of(20, 0));
    const LinearBound bound = tight_bound(stencils);
    EXPECT_DOUBLE_EQ(bound.f_found, f_of(20, 0));
    EXPECT_NEAR(bound.f_upper, f_of(20, 0), 0.001);
}

TEST(LinearBound, KeepsItWhereTheNoiseIsLittle) {
    LinearStencils stencils(up_to(10));
    add_truth(stencils, 10, {1, 0, 0, 0});
    add_truth(stencils, 20, {0, 1, 0, 0});
    add_far(stencils, 20, {-1.01F, 0, 0, 0});
    const LinearBound bound = tight_bound(stencils);
    EXPECT_DOUBLE_EQ(bound.f_found, f_of(30, 20));
    EXPECT_NEAR(bound.f_upper, f_of(30, 20), 0.001);
}

/// Three creases across which one component of the normal gives way to another. To show all three,
/// the weights must lie 1 apart: 0, 1, 2 at least, 3 in all.
LinearStencils three_turns(double most_sum) {
    LinearStencils stencils(up_to(most_sum));
    add_truth(stencils, 10, {0, 1, -1, 0});
    add_truth(stencils, 10, {0, 0, 1, -1});
    add_truth(stencils, 10, {0, 1, 0, -1});
    return stencils;
}

TEST(LinearBound, CancellationCostsAThirdWhereTheRangeIsTooNarrow) {
    const LinearBound narrow = tight_bound(three_turns(2.9));
    EXPECT_DOUBLE_EQ(narrow.f_found, f_of(20, 0));
    EXPECT_NEAR(narrow.f_upper, f_of(20, 0), 0.001);
    const LinearBound wide = tight_bound(three_turns(3.3));
    EXPECT_EQ(wide.f_found, 1);
}

TEST(LinearBound, OfSignedWeightsNeedsLessRangeForTheSame) {
    // -1, 0, 1: two in all.
    WeightDomain domain = up_to(2.3);
    domain.is_signed = true;
    LinearStencils stencils(domain);
    stencils.add(three_turns(2.3));
    EXPECT_EQ(tight_bound(stencils).f_found, 1);
    EXPECT_DOUBLE_EQ(tight_bound(three_turns(2.3)).f_found, f_of(20, 0));
}

TEST(LinearBound, OfAPositiveResponseSeesOneSideOnly) {
    WeightDomain domain = up_to(10);
    domain.response = edge::Response::positive;
    LinearStencils stencils(domain);
    add_truth(stencils, 10, {-1, 0, 0, 0});
    add_truth(stencils, 20, {1, 0, 0, 0});
    const LinearBound bound = tight_bound(stencils);
    EXPECT_DOUBLE_EQ(bound.f_found, f_of(20, 0));
    EXPECT_NEAR(bound.f_upper, f_of(20, 0), 0.001);
}

TEST(LinearBound, CountsTruthThatNothingCanShow) {
    LinearStencils stencils(up_to(10));
    add_truth(stencils, 15, {1, 0, 0, 0});
    add_truth(stencils, 15, {0, 0.05F, 0, 0});  // 10 * 0.05 < 1
    EXPECT_EQ(stencils.findable(), 15U);
    EXPECT_NEAR(tight_bound(stencils).f_upper, f_of(15, 0), 1e-12);
}

TEST(LinearBound, OfNothingIsOne) {
    const LinearStencils stencils(up_to(10));
    const LinearBound bound = linear_bound(stencils, {});
    EXPECT_EQ(bound.f_found, 1);
    EXPECT_EQ(bound.f_upper, 1);
}

TEST(LinearBound, RoundingMayHelpAStepOverTheThreshold) {
    WeightDomain domain = up_to(1);
    for (const double rounding : {0.0, 0.25}) {
        domain.rounding = rounding;
        LinearStencils stencils(domain);
        add_truth(stencils, 30, {0.8F, 0, 0, 0});
        const LinearBound bound = linear_bound(stencils, {.most_boxes = 100});
        EXPECT_EQ(bound.f_upper, rounding > 0 ? 1 : 0);
        EXPECT_EQ(bound.f_found, 0) << "weights are as they are";
        EXPECT_EQ(linear_count(stencils, {1, 0, 0, 0}, rounding).found, rounding > 0 ? 30 : 0);
    }
}

/// A catalogue scene's first view with its truth and planes.
struct SmallView {
    method::LinearCode code;
    harness::ViewTruth truth;
    ChannelPlanes planes;
};

SmallView small_view(const std::string& name, int width_px, int height_px) {
    harness::ViewRequest request;
    request.width_px = width_px;
    request.height_px = height_px;
    const harness::SceneViews scene_views =
        harness::make_scene_views(catalogue::make_catalogue_scene(name), request);
    SmallView result;
    result.code = *methods::find_method("mote4").make({})->code();
    truth::SceneModel model(scene_views.scene, {});
    result.truth = harness::trace_view(model, scene_views.views.front(), {});
    const ChannelSource source(scene_views.scene, result.code);
    result.planes =
        source.planes(scene_views.views.front(), result.truth.traced.layers.triangle, 1);
    return result;
}

LinearStencils stencils_of(const SmallView& view, const WeightDomain& domain) {
    LinearStencils stencils(domain);
    stencils.add(view.planes, view.truth.scoring);
    return stencils;
}

/// Weights of 255 codes in all, some small.
LinearWeights random_codes(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    LinearWeights codes{};
    double sum = 0;
    for (double& weight : codes) {
        weight = std::pow(unit(random), 2) + 0.02;
        sum += weight;
    }
    for (double& weight : codes)
        weight *= 254.9 / sum;
    return codes;
}

/// What the scorer makes of a code that is drawn: weights and threshold in codes, times `finer`.
double measured_f(const SmallView& view, const LinearWeights& codes, int threshold, int finer) {
    method::LinearCode code = view.code;
    code.bits = 16;
    code.depth_weight = codes[0] * (1 << finer);
    for (std::size_t k = 0; k < 3; ++k)
        code.normal_weight[k] = codes[k + 1] * (1 << finer);
    code.response = {.clip_bits = 0, .scale_bits = -finer, .code_bits = 16, .code_wraps = false};
    const auto edge_responses = responses_of(view.planes, code, 1);
    return score::score(edge_responses, view.truth.scoring, harness::score_options(threshold)).f();
}

TEST(LinearCount, IsNotBelowWhatTheScorerMeasures) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> thresholds(2, 30);
    WeightDomain domain = up_to(128);
    domain.rounding = 2;
    for (const char* scene : {"torus", "teapot", "figure", "flag", "tree", "room", "gem", "soup"}) {
        const SmallView view = small_view(scene, 320, 180);
        const LinearStencils stencils = stencils_of(view, domain);
        for (int trial = 0; trial < 50; ++trial) {
            const LinearWeights codes = random_codes(random);
            const int threshold = thresholds(random);
            LinearWeights weights = codes;
            for (double& weight : weights)
                weight /= threshold;
            // As good as not rounded: 1/256 of a code.
            const double fine = 4.0 / 256 / threshold;
            EXPECT_LE(measured_f(view, codes, threshold, 8),
                      linear_count(stencils, weights, fine).f() + 0.002)
                << scene << ", threshold " << threshold;
            // A byte.
            EXPECT_LE(measured_f(view, codes, threshold, 0),
                      linear_count(stencils, weights, 4.0 / threshold).f() + 0.002)
                << scene << ", threshold " << threshold;
        }
    }
}

TEST(LinearBound, IsAboveEveryWeightOfAGrid) {
    const SmallView view = small_view("gem", 160, 90);
    const LinearStencils stencils = stencils_of(view, up_to(40));
    double best = 0;
    for (double w0 = 0; w0 <= 40; w0 += 4) {
        for (double w1 = 0; w0 + w1 <= 40; w1 += 4) {
            for (double w2 = 0; w0 + w1 + w2 <= 40; w2 += 4) {
                for (double w3 = 0; w0 + w1 + w2 + w3 <= 40; w3 += 4)
                    best = std::max(best, linear_count(stencils, {w0, w1, w2, w3}).f());
            }
        }
    }
    const LinearBound bound = linear_bound(stencils, {.gap = 0.005});
    EXPECT_GE(bound.f_upper, best);
    EXPECT_GE(bound.f_found, best - 0.005);
    EXPECT_LE(bound.gap(), 0.005);
    EXPECT_TRUE(stencils.domain().contains(bound.weights));
    EXPECT_DOUBLE_EQ(linear_count(stencils, bound.weights).f(), bound.f_found);
    EXPECT_DOUBLE_EQ(bound.count.f(), bound.f_found);
}

TEST(LinearBound, OnlyTightensWithMoreBoxes) {
    const SmallView view = small_view("crystals", 160, 90);
    const LinearStencils stencils = stencils_of(view, up_to(63.75));
    LinearBound last;
    for (const int boxes : {1, 2, 7, 40, 100, 333, 1000}) {
        const LinearBound bound = linear_bound(stencils, {.gap = 0, .most_boxes = boxes});
        EXPECT_LE(bound.boxes, boxes + 1);
        EXPECT_LE(bound.f_upper, last.f_upper) << boxes;
        EXPECT_GE(bound.f_found, last.f_found) << boxes;
        EXPECT_GE(bound.f_upper, bound.f_found);
        last = bound;
    }
}

TEST(LinearBound, IsTheSameForEveryThreadCount) {
    const SmallView view = small_view("crystals", 160, 90);
    const LinearStencils stencils = stencils_of(view, up_to(63.75));
    LinearBoundOptions options{.gap = 0.002, .most_boxes = 2000};
    const LinearBound one = linear_bound(stencils, options);
    options.threads = 3;
    const LinearBound three = linear_bound(stencils, options);
    EXPECT_EQ(one.f_upper, three.f_upper);
    EXPECT_EQ(one.f_found, three.f_found);
    EXPECT_EQ(one.weights, three.weights);
    EXPECT_EQ(one.boxes, three.boxes);
}

TEST(LinearBound, TriesWhatItIsGivenFirst) {
    LinearStencils stencils(up_to(10));
    add_truth(stencils, 30, {0.5F, 0.25F, 0, 0});
    const LinearWeights start{1.5, 1.25, 0, 0};
    const LinearBound bound = linear_bound(
        stencils, {.most_boxes = 1, .starts = {{20, 0, 0, 0}, {-1, 0, 0, 0}, start, {1, 0, 0, 0}}});
    EXPECT_EQ(bound.weights, start);
    EXPECT_EQ(bound.f_found, 1);
}

}  // namespace
}  // namespace ink::linear_code
