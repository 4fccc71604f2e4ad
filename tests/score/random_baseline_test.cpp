#include "score/drawing.h"

#include <gtest/gtest.h>

#include "tests/score/images.h"

namespace {

using ink::score::CurveCount;
using ink::score::prepare_truth;
using ink::score::RandomBaseline;
using ink::score::ScoreOptions;

/// A horizontal line across the middle.
Image line_across(int width_px, int height_px) {
    Image labels(width_px, height_px);
    for (int x = 0; x < width_px; ++x)
        labels.at(x, height_px / 2) = 1;
    return labels;
}

TEST(RandomBaseline, DrawsAsManyPixelsAsItIsTold) {
    const auto truth = prepare_truth(line_across(100, 60), {}, false);
    const RandomBaseline random_baseline(truth, {}, 7);
    for (const std::int64_t n : {0, 1, 50, 400})
        EXPECT_EQ(random_baseline.counts(n).n_pred, n);
    EXPECT_EQ(random_baseline.counts(1'000'000), (CurveCount{100, 6000, 100})) << "the whole image";
    EXPECT_EQ(random_baseline.counts(0).f(), 0);
}

TEST(RandomBaseline, IsTheSameForASeed) {
    const auto truth = prepare_truth(line_across(100, 60), {}, false);
    const CurveCount first = RandomBaseline(truth, {}, 7).counts(300);
    EXPECT_EQ(RandomBaseline(truth, {}, 7).counts(300), first);
    int different = 0;
    for (std::uint64_t seed = 8; seed < 16; ++seed)
        different += RandomBaseline(truth, {}, seed).counts(300) == first ? 0 : 1;
    EXPECT_GT(different, 0);
}

TEST(RandomBaseline, KeepsOutOfBandAndIgnored) {
    Image labels = line_across(100, 60);
    for (int y = 6; y < 20; ++y) {
        for (int x = 6; x < 94; ++x)
            labels.at(x, y) = 7;
    }
    const ScoreOptions options{.band_px = 6, .ignore_label = 7};
    const auto truth = prepare_truth(labels, options, false);
    const RandomBaseline random_baseline(truth, options, 1);
    // 88 x 34 places are left; two rows of them lie beside the ignored ones, out of reach of truth.
    EXPECT_EQ(random_baseline.counts(1'000'000), (CurveCount{88, 88 * 32, 88}));
}

TEST(RandomBaseline, IsNearTheShareOfTheImageInReach) {
    // 200 random pixels beside a line of 2000: hardly any competition, so each matches if it falls
    // within 2 px, which five rows of 200 are: 200 * 5 / 200 = 5, give or take.
    const auto truth = prepare_truth(line_across(2000, 200), {}, false);
    double k = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        k += static_cast<double>(RandomBaseline(truth, {}, seed).counts(200).k);
    EXPECT_NEAR(k / 40, 5, 1.1);  // three standard deviations of the mean of 40: 3 * 2.2 / 6.3
}

}  // namespace
