#include <gtest/gtest.h>

#include "edge/thin.h"
#include "score/score.h"
#include "tests/score/images.h"

namespace {

using ink::score::CurveCount;
using ink::score::prepare_truth;
using ink::score::ScoreOptions;

using Curve = std::array<CurveCount, 99>;

TEST(Curve, EqualsAScoreAtEachThreshold) {
    std::mt19937 random(31);
    const Image drawn = random_image(135, 50, 0.3, 255, random);
    const Image labels = random_image(135, 50, 0.1, 7, random);
    const ScoreOptions options{.tolerance_px = 2, .band_px = 3, .ignore_label = 7};
    const auto truth = prepare_truth(labels, options, false);
    const Curve curve = ink::score::score_curve(drawn, truth, options);
    for (int k = 1; k <= 99; ++k) {
        ScoreOptions at_k = options;
        at_k.threshold = ink::edge::response_at_percent(k);
        const auto s = ink::score::score(drawn, truth, at_k);
        const CurveCount& c = curve[static_cast<std::size_t>(k - 1)];
        ASSERT_EQ(c.k, s.k) << k;
        ASSERT_EQ(c.n_pred, s.n_pred) << k;
        ASSERT_EQ(c.n_truth, s.n_truth) << k;
    }
}

/// n triples of `with`, the rest of `without`.
Curve two_level_curve(std::size_t n, CurveCount with, CurveCount without) {
    Curve curve;
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = i < n ? with : without;
    return curve;
}

TEST(AveragePrecision, OfAPerfectYesOrNoDetectorIsOne) {
    EXPECT_DOUBLE_EQ(ink::score::average_precision(two_level_curve(99, {8, 8, 8}, {})), 1);
    EXPECT_DOUBLE_EQ(ink::score::average_precision(two_level_curve(50, {8, 8, 8}, {0, 0, 8})), 1);
}

TEST(AveragePrecision, IsTheAreaUnderTheEnvelope) {
    // Recall 1 at precision 1/2, recall 1/4 at precision 1: 1/4 * 1 + 3/4 * 1/2.
    const Curve curve = two_level_curve(40, {8, 16, 8}, {2, 2, 8});
    EXPECT_DOUBLE_EQ(ink::score::average_precision(curve), 0.625);
    // A point under the envelope takes nothing away: precision 1/4 at recall 1/4.
    const Curve dented = two_level_curve(40, {8, 16, 8}, {2, 8, 8});
    EXPECT_DOUBLE_EQ(ink::score::average_precision(dented), 0.5);
}

TEST(AveragePrecision, WithoutTruthIsOneOnlyIfNothingFires) {
    EXPECT_EQ(ink::score::average_precision(two_level_curve(99, {}, {})), 1);
    EXPECT_EQ(ink::score::average_precision(two_level_curve(1, {0, 3, 0}, {})), 0);
    EXPECT_EQ(ink::score::average_precision(two_level_curve(99, {0, 0, 5}, {})), 0);
}

}  // namespace
