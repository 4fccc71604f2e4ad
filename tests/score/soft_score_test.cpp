#include "score/soft_score.h"

#include <gtest/gtest.h>

#include <random>

#include "score/coverage.h"
#include "tests/score/curves.h"

namespace {

using ink::core::Image;
using ink::score::InkTruth;
using ink::score::ScoreOptions;
using ink::score::SoftScore;
using Ink = Image<float>;

constexpr int kSize_px = 32;

ScoreOptions within(double tolerance_px, int band_px = 0) {
    ScoreOptions options;
    options.tolerance_px = tolerance_px;
    options.band_px = band_px;
    options.ignore_label = 7;
    return options;
}

InkTruth truth_of(const Ink& coverage,
                  const ScoreOptions& options,
                  const ::Image& labels = ::Image(kSize_px, kSize_px)) {
    return prepare_ink(coverage, 1.5, prepare_truth(labels, options, false), options);
}

Ink drawn(const Curves& curves) {
    return ink::score::draw_coverage(curves, kSize_px, kSize_px, 1.5);
}

Ink dots(std::initializer_list<std::tuple<int, int, float>> of) {
    Ink image(kSize_px, kSize_px);
    for (const auto& [x, y, share] : of)
        image.at(x, y) = share;
    return image;
}

/// Shares without rhyme or reason in a tenth of the pixels.
Ink random_ink(unsigned seed) {
    std::mt19937 random(seed);
    Ink image(kSize_px, kSize_px);
    for (std::size_t i = 0; i < image.size(); ++i)
        if (random() % 10 == 0) image.data()[i] = static_cast<float>(random() % 256) / 255;
    return image;
}

TEST(SoftScore, OfTheTruthIsOneAndOfNothingZero) {
    const Ink coverage = drawn(circle(16, 16, 9, 40));
    const InkTruth truth = truth_of(coverage, within(2));
    const SoftScore self = score_ink(coverage, truth, within(2));
    EXPECT_EQ(self.f(), 1);
    EXPECT_EQ(self.misplaced_px, 0);
    EXPECT_EQ(self.missing_px, 0);
    EXPECT_EQ(self.surplus_px, 0);
    const SoftScore blank = score_ink(Ink(kSize_px, kSize_px), truth, within(2));
    EXPECT_EQ(blank.f(), 0);
    EXPECT_DOUBLE_EQ(blank.missing_px, self.true_px());
    EXPECT_EQ(blank.drawn_px(), 0);
}

TEST(SoftScore, OfAnEmptyTruthIsNothing) {
    const InkTruth truth = truth_of(Ink(kSize_px, kSize_px), within(2));
    const SoftScore score = score_ink(random_ink(1), truth, within(2));
    EXPECT_FALSE(score.f());
    EXPECT_GT(score.surplus_px, 0);
}

TEST(SoftScore, TellsMissingMisplacedAndSurplusInkApart) {
    const InkTruth truth = truth_of(dots({{8, 8, 0.75F}, {20, 8, 0.5F}, {8, 20, 1}}), within(2));
    // At its place in part, two pixels beside, three pixels beside.
    const SoftScore score =
        score_ink(dots({{8, 8, 0.5F}, {22, 8, 0.75F}, {11, 20, 1}}), truth, within(2));
    EXPECT_DOUBLE_EQ(score.matched_px, 0.5);
    EXPECT_DOUBLE_EQ(score.misplaced_px, 0.5);
    EXPECT_DOUBLE_EQ(score.surplus_px, 0.25 + 1);
    EXPECT_DOUBLE_EQ(score.missing_px, 0.25 + 1);
    EXPECT_DOUBLE_EQ(*score.f(), 2 * 0.5 / (2.25 + 2.25));
    EXPECT_DOUBLE_EQ(score_ink(dots({{11, 20, 1}}), truth, within(3)).misplaced_px, 1);
}

TEST(SoftScore, MovesInkToTheNearestPlaceFirst) {
    const InkTruth truth = truth_of(dots({{8, 8, 1}, {13, 8, 1}}), within(3));
    // Two pixels from the left place and three from the right, which another one is nearer to.
    const SoftScore score = score_ink(dots({{10, 8, 1}, {14, 8, 0.5F}}), truth, within(3));
    EXPECT_DOUBLE_EQ(score.misplaced_px, 1.5);
    EXPECT_DOUBLE_EQ(score.missing_px, 0.5);
    EXPECT_DOUBLE_EQ(score.surplus_px, 0);
}

TEST(SoftScore, AddsUpToAllInk) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Ink coverage = random_ink(seed);
        const Ink image = random_ink(seed + 100);
        const SoftScore score = score_ink(image, truth_of(coverage, within(2)), within(2));
        double drawn_px = 0, true_px = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            drawn_px += image.data()[i];
            true_px += coverage.data()[i];
        }
        EXPECT_NEAR(score.drawn_px(), drawn_px, 1e-9);
        EXPECT_NEAR(score.true_px(), true_px, 1e-9);
        // The other way round other moves come first. As no ink is left that could move, either
        // way moves at least half of the most that any could.
        const SoftScore other = score_ink(coverage, truth_of(image, within(2)), within(2));
        EXPECT_NEAR(other.matched_px, score.matched_px, 1e-9);
        EXPECT_LE(other.misplaced_px, 2 * score.misplaced_px);
        EXPECT_LE(score.misplaced_px, 2 * other.misplaced_px);
    }
}

TEST(SoftScore, OfALineOnePixelBesideIsMisplacedNotMissing) {
    const InkTruth truth = truth_of(drawn({curve(4, 16, 28, 16)}), within(2));
    const SoftScore beside = score_ink(drawn({curve(4, 17, 28, 17)}), truth, within(2));
    EXPECT_GT(beside.matched_px, 0.75 * 24);
    EXPECT_GT(beside.misplaced_px, 0.75 * 24);
    EXPECT_LT(beside.missing_px, 0.1);
    EXPECT_LT(beside.surplus_px, 0.1);
    const SoftScore far = score_ink(drawn({curve(4, 24, 28, 24)}), truth, within(2));
    EXPECT_EQ(far.misplaced_px, 0);
    EXPECT_EQ(far.f(), 0);
}

TEST(SoftScore, LeavesOutTheBandAndWhatIsNearIgnoredPixels) {
    ::Image labels(kSize_px, kSize_px);
    labels.at(16, 16) = 7;
    const ScoreOptions options = within(2, 6);
    const InkTruth truth = truth_of(Ink(kSize_px, kSize_px, 0.5F), options, labels);
    const SoftScore score = score_ink(Ink(kSize_px, kSize_px, 1), truth, options);
    constexpr int kCounted = 20 * 20 - 13;  // 13 pixels are at most 2 px from the ignored one
    EXPECT_DOUBLE_EQ(score.true_px(), kCounted * 0.5);
    EXPECT_DOUBLE_EQ(score.drawn_px(), kCounted);
    EXPECT_DOUBLE_EQ(*score.f(), 2 * 0.5 / 1.5);
}

TEST(SoftScore, TakesStrengthsByTheirThresholdAndGreyAsItIs) {
    ::Image image(3, 1);
    image.at(1, 0) = 51;
    image.at(2, 0) = 102;
    EXPECT_EQ(ink::score::ink_of(image).at(1, 0), 0.2F);
    EXPECT_EQ(ink::score::ink_of(image, 102).at(1, 0), 0);
    EXPECT_EQ(ink::score::ink_of(image, 102).at(2, 0), 1);
}

}  // namespace
