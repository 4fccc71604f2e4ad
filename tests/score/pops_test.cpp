#include <gtest/gtest.h>

#include <algorithm>

#include "score/motion.h"
#include "tests/score/curves.h"
#include "tests/score/images.h"

namespace {

using namespace ink;
using score::FeatureSight;
using score::PopCount;

constexpr int kSize_px = 40;
constexpr score::ScoreOptions kOptions{.tolerance_px = 2, .threshold = 1, .band_px = 6};

/// A truth with level lines in `rows`, those of the curves unless said.
score::ScoringTruth truth_in(const std::vector<int>& rows = {10, 12, 20, 30}) {
    Image labels(kSize_px, kSize_px);
    for (const int y : rows) {
        for (int x = 0; x < kSize_px; ++x)
            labels.at(x, y) = 1;
    }
    return score::prepare_truth(labels, {.threshold = 1}, true);
}

/// A crease of mesh edge `edge` across the whole image, 28 px of it outside the band.
truth::Curve level(double y_px, std::uint32_t edge) {
    truth::Curve c = curve(0, y_px, kSize_px, y_px);
    c.edge = edge;
    return c;
}

TEST(Features, AreMeasuredOutsideTheBand) {
    const auto sights = score::see_features(
        Curves{level(20.5, 3)}, Image(kSize_px, kSize_px), truth_in(), kOptions);
    ASSERT_EQ(sights.size(), 1U);
    EXPECT_EQ(sights[0].feature,
              (score::Feature{.line_class = truth::LineClass::crease, .edge = 3}));
    EXPECT_DOUBLE_EQ(sights[0].length_px, 28);
    EXPECT_EQ(sights[0].covered_px, 0);
}

TEST(Features, AreCoveredWithinTheTolerance) {
    const Image near = drawn_where(kSize_px, kSize_px, [](double x, double y) {
        return y == 22.5 && x < 20;  // two rows below, the left half
    });
    const Image far = drawn_where(kSize_px, kSize_px, [](double, double y) { return y == 23.5; });
    const Curves curves{level(20.5, 3)};
    // Straight below only: a pixel to the side is further than 2.
    EXPECT_DOUBLE_EQ(score::see_features(curves, near, truth_in(), kOptions)[0].share(), 0.5);
    EXPECT_EQ(score::see_features(curves, far, truth_in(), kOptions)[0].share(), 0);
}

TEST(Features, PiecesOfOneEdgeAreOneFeatureAndClassesAreNot) {
    Curves curves{level(20.5, 9), level(10.5, 2), level(12.5, 9), level(30.5, 9)};
    curves[3].line_class = truth::LineClass::contour;
    const auto sights =
        score::see_features(curves, Image(kSize_px, kSize_px), truth_in(), kOptions);
    ASSERT_EQ(sights.size(), 3U);
    EXPECT_EQ(sights[0].feature.line_class, truth::LineClass::contour);
    EXPECT_EQ(sights[1].feature.edge, 2U);
    EXPECT_EQ(sights[2].feature.edge, 9U);
    EXPECT_DOUBLE_EQ(sights[2].length_px, 56);
}

TEST(Features, AnIntersectionIsKnownByItsTrianglesInEitherOrder) {
    Curves curves{level(20.5, truth::kNoEdge), level(10.5, truth::kNoEdge)};
    for (truth::Curve& c : curves)
        c.line_class = truth::LineClass::intersection;
    curves[0].face0 = 8;
    curves[0].face1 = 5;
    curves[1].face0 = 5;
    curves[1].face1 = 8;
    const auto sights =
        score::see_features(curves, Image(kSize_px, kSize_px), truth_in(), kOptions);
    ASSERT_EQ(sights.size(), 1U);
    EXPECT_EQ(sights[0].feature.face0, 5U);
    EXPECT_EQ(sights[0].feature.face1, 8U);
}

TEST(Features, ArePartlyIgnored) {
    Image labels(kSize_px, kSize_px);
    for (int x = 0; x < kSize_px; ++x)
        labels.at(x, 20) = x < 20 ? 7 : 1;
    const auto truth = score::prepare_truth(labels, {.threshold = 1, .ignore_label = 7}, true);
    const Image empty(kSize_px, kSize_px);
    const auto sights = score::see_features(Curves{level(20.5, 3)}, empty, truth, kOptions);
    EXPECT_DOUBLE_EQ(sights[0].length_px, 14);  // columns 20 to 33
}

TEST(Features, IgnoredAndInvisiblePiecesAreNotThere) {
    const auto ignored = score::prepare_truth(
        Image(kSize_px, kSize_px, 7), {.threshold = 1, .ignore_label = 7}, true);
    const Image empty(kSize_px, kSize_px);
    EXPECT_TRUE(score::see_features(Curves{level(20.5, 3)}, empty, ignored, kOptions).empty());
    const auto elsewhere = truth_in({23});
    EXPECT_TRUE(score::see_features(Curves{level(20.5, 3)}, empty, elsewhere, kOptions).empty());
    EXPECT_FALSE(score::see_features(Curves{level(21.5, 3)}, empty, elsewhere, kOptions).empty());
    EXPECT_TRUE(score::see_features(Curves{level(2.5, 3)}, empty, truth_in(), kOptions).empty());
    EXPECT_TRUE(score::see_features({}, empty, truth_in(), kOptions).empty());
}

/// A sequence of one feature: S shown, D dropped, h half shown, '.' not there, s too short.
std::vector<std::vector<FeatureSight>> sequence_of(const std::string& letters,
                                                   std::uint32_t edge = 1) {
    std::vector<std::vector<FeatureSight>> frames;
    for (const char letter : letters) {
        FeatureSight sight{.feature = {.edge = edge}, .length_px = 12};
        if (letter == 'S') sight.covered_px = 8;
        if (letter == 'h') sight.covered_px = 6;
        if (letter == 'D') sight.covered_px = 4;
        if (letter == 's') sight.length_px = 3.9;
        frames.emplace_back();
        if (letter != '.') frames.back().push_back(sight);
    }
    return frames;
}

PopCount pops_of(const std::string& letters) {
    return score::count_pops(sequence_of(letters));
}

TEST(Pops, NeedShownDroppedAndShownAgain) {
    EXPECT_EQ(pops_of("SSSS"), (PopCount{.pops = 0, .runs = 1, .steps = 3}));
    EXPECT_EQ(pops_of("DDDD"), (PopCount{.pops = 0, .runs = 1, .steps = 3}));
    EXPECT_EQ(pops_of("SDS"), (PopCount{.pops = 1, .runs = 1, .steps = 2}));
    EXPECT_EQ(pops_of("SDDDS").pops, 1);
    EXPECT_EQ(pops_of("SDSDSD").pops, 2);
    EXPECT_EQ(pops_of("SSDD").pops, 0);
    EXPECT_EQ(pops_of("DDSS").pops, 0);
    EXPECT_EQ(pops_of("DSD").pops, 0);
}

TEST(Pops, HalfShownKeepsWhatItWas) {
    EXPECT_EQ(pops_of("ShShS").pops, 0);
    EXPECT_EQ(pops_of("ShDhS").pops, 1);
    EXPECT_EQ(pops_of("hDhShD").pops, 0);
}

TEST(Pops, AFeatureThatIsAwayStartsAnew) {
    EXPECT_EQ(pops_of("SSS.SSS"), (PopCount{.pops = 0, .runs = 2, .steps = 4}));
    EXPECT_EQ(pops_of("SSD.DSS").pops, 0);
    EXPECT_EQ(pops_of("SSDsDSS").pops, 0);
}

TEST(Pops, RunsTooShortToPopDoNotCount) {
    EXPECT_EQ(pops_of("SD.DS.S"), PopCount{});
    EXPECT_EQ(pops_of(""), PopCount{});
}

TEST(Pops, AreCountedPerFeature) {
    auto frames = sequence_of("SDSDS", 1);
    const auto second = sequence_of("SSDSS", 2);
    for (std::size_t t = 0; t < frames.size(); ++t)
        frames[t].push_back(second[t].front());
    EXPECT_EQ(score::count_pops(frames), (PopCount{.pops = 3, .runs = 2, .steps = 8}));
}

TEST(Pops, AreTheSameBackwards) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> letter(0, 4);
    for (int round = 0; round < 200; ++round) {
        std::string letters(12, '.');
        for (char& c : letters)
            c = "SDh.S"[letter(random)];
        const PopCount there = pops_of(letters);
        std::reverse(letters.begin(), letters.end());
        EXPECT_EQ(pops_of(letters), there) << letters;
    }
}

}  // namespace
