#include "score/attribution.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/score/images.h"

namespace ink::score {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

core::Image<std::uint32_t> ids_of(const Rows& rows) {
    const Image digits = image_of(rows);
    core::Image<std::uint32_t> ids(digits.width_px(), digits.height_px());
    std::copy(digits.data(), digits.data() + digits.size(), ids.data());
    return ids;
}

/// Made-up layers of one size, all sky and without lines unless said.
struct Layers {
    core::Image<std::uint32_t> triangle;
    core::Image<std::uint32_t> patch;
    truth::Cracks cracks;
    Image labels;

    explicit Layers(const Rows& triangles)
        : triangle(ids_of(triangles)),
          patch(triangle),
          cracks{Image(triangle.width_px(), triangle.height_px()),
                 Image(triangle.width_px(), triangle.height_px())},
          labels(triangle.width_px(), triangle.height_px()) {}

    [[nodiscard]] TruthStencils stencils() const { return {triangle, patch, cracks, labels}; }
    [[nodiscard]] edge::Mask nothing() const { return {triangle.width_px(), triangle.height_px()}; }
    /// The cause of the one off-line pixel (x, y).
    [[nodiscard]] Cause false_positives(Pixel pixel, const ScoreOptions& options = {}) const {
        return attribute({{pixel}, {}, nothing()}, stencils(), {}, options).pixels.at(0).cause;
    }
    /// The cause of the one missing pixel if this was predicted.
    [[nodiscard]] Cause miss(Pixel pixel, Cause predicted, const edge::Mask& drawn) const {
        const Cause causes[] = {predicted};
        return attribute({{}, {pixel}, drawn}, stencils(), causes, {}).pixels.at(0).cause;
    }
};

const Rows kTwoHalves = {"1112222", "1112222", "1112222", "1112222", "1112222"};

TEST(FalsePositiveCause, OneTriangleFillsTheStencil) {
    const Layers layers(kTwoHalves);
    EXPECT_EQ(layers.false_positives({1, 2}), Cause::one_triangle);
    EXPECT_EQ(layers.false_positives({4, 2}), Cause::one_triangle);
}

TEST(FalsePositiveCause, TheCornersOfTheStencilCount) {
    Layers layers({"11111", "11111", "11111", "11112", "11112"});
    layers.patch.fill(9);
    EXPECT_EQ(layers.false_positives({2, 2}), Cause::one_triangle) << "the two lie two pixels off";
    EXPECT_EQ(layers.false_positives({3, 2}), Cause::one_patch) << "its lower right corner sees 2";
}

TEST(FalsePositiveCause, SeveralTrianglesOfOnePatch) {
    Layers layers(kTwoHalves);
    EXPECT_EQ(layers.false_positives({2, 2}), Cause::other) << "two patches";
    layers.patch.fill(9);
    EXPECT_EQ(layers.false_positives({2, 2}), Cause::one_patch);
}

TEST(FalsePositiveCause, SkyIsASurfaceOfItsOwn) {
    Layers layers(kTwoHalves);
    layers.patch.fill(9);
    for (int y = 0; y < 5; ++y)
        layers.triangle.at(6, y) = layers.patch.at(6, y) = 0xffffffffU;
    EXPECT_EQ(layers.false_positives({5, 2}), Cause::other);
    layers.triangle.fill(0xffffffffU);
    EXPECT_EQ(layers.false_positives({3, 2}), Cause::one_triangle) << "sky alone";
}

TEST(FalsePositiveCause, ACrackAnywhereInTheStencilOutweighsThePatch) {
    Layers layers(kTwoHalves);
    layers.patch.fill(9);
    layers.cracks.below.at(4, 1) = 3;  // between (4,1) and (4,2)
    EXPECT_EQ(layers.false_positives({3, 2}), Cause::crack);
    EXPECT_EQ(layers.false_positives({2, 2}), Cause::one_patch) << "out of its stencil";
    layers.cracks.below.at(4, 1) = 0;
    layers.cracks.right.at(2, 3) = 1;  // between (2,3) and (3,3)
    EXPECT_EQ(layers.false_positives({3, 2}), Cause::crack);
    layers.cracks.right.at(2, 3) = 0;
    layers.cracks.right.at(4, 2) = 1;  // between (4,2) and (5,2): half out of it
    EXPECT_EQ(layers.false_positives({3, 2}), Cause::one_patch);
}

TEST(FalsePositiveCause, OneTriangleOutweighsACrack) {
    Layers layers(kTwoHalves);
    layers.cracks.right.at(4, 2) = 1;
    EXPECT_EQ(layers.false_positives({5, 2}), Cause::one_triangle);
}

TEST(FalsePositiveCause, WhereTheStencilLeavesTheImageItIsTheFrame) {
    const Layers layers({"111", "111", "111"});
    EXPECT_EQ(layers.false_positives({1, 1}), Cause::one_triangle);
    for (const Pixel pixel : {Pixel{0, 1}, {2, 1}, {1, 0}, {1, 2}})
        EXPECT_EQ(layers.false_positives(pixel), Cause::frame);
}

TEST(FalsePositiveCause, ATrueLineThatTheBandTookAwayIsTheFrame) {
    Layers layers(Rows(12, "111111111111"));
    layers.labels.at(1, 5) = 1;
    layers.labels.at(9, 5) = 1;
    ScoreOptions options{.tolerance_px = 2, .band_px = 2, .ignore_label = 7};
    EXPECT_EQ(layers.false_positives({3, 5}, options), Cause::frame) << "two pixels from it";
    EXPECT_EQ(layers.false_positives({3, 6}, options), Cause::one_triangle) << "sqrt(5) from it";
    EXPECT_EQ(layers.false_positives({8, 5}, options), Cause::one_triangle)
        << "that one is no band truth";
    layers.labels.at(1, 5) = 7;
    EXPECT_EQ(layers.false_positives({3, 5}, options), Cause::one_triangle) << "ignored, no truth";
}

TEST(SeesLine, TakesACrackAndTwoTriangles) {
    Layers layers(kTwoHalves);
    EXPECT_FALSE(sees_line(layers.stencils(), {2, 2})) << "two triangles, no crack";
    layers.cracks.right.at(2, 2) = 3;
    EXPECT_TRUE(sees_line(layers.stencils(), {2, 2})) << "to its right";
    EXPECT_TRUE(sees_line(layers.stencils(), {3, 2})) << "to its left";
    EXPECT_FALSE(sees_line(layers.stencils(), {2, 1})) << "no corner of the cross";
    layers.cracks.right.at(4, 2) = 3;
    EXPECT_FALSE(sees_line(layers.stencils(), {5, 2})) << "a crack within one triangle";
    layers.cracks.right.at(2, 2) = 0;
    layers.cracks.right.at(3, 2) = 3;
    EXPECT_TRUE(sees_line(layers.stencils(), {3, 2})) << "the centre may lie on the line";
}

TEST(SeesLine, LooksUpAndDownAndStaysInTheImage) {
    Layers layers({"11", "11", "22"});
    layers.cracks.below.at(0, 1) = 1;
    EXPECT_TRUE(sees_line(layers.stencils(), {0, 1}));
    EXPECT_TRUE(sees_line(layers.stencils(), {0, 2}));
    EXPECT_FALSE(sees_line(layers.stencils(), {0, 0}));
    EXPECT_FALSE(sees_line(layers.stencils(), {1, 2}));
}

TEST(SeeingStencils, AreThoseRoundThePixelRowByRow) {
    Layers layers(kTwoHalves);
    layers.cracks.right.at(2, 1) = layers.cracks.right.at(2, 2) = 1;
    layers.cracks.right.at(2, 4) = 1;
    EXPECT_THAT(seeing_stencils(layers.stencils(), {2, 2}),
                ElementsAre(Pixel{2, 1}, Pixel{3, 1}, Pixel{2, 2}, Pixel{3, 2}));
    EXPECT_THAT(seeing_stencils(layers.stencils(), {0, 0}), IsEmpty());
}

/// A false negative at (2, 2) with a crack to its right that two triangles are seen across.
Layers seen_line() {
    Layers layers(kTwoHalves);
    layers.cracks.right.at(2, 2) = 1;
    return layers;
}

TEST(FalseNegativeCause, IsWhatWasPredicted) {
    const Layers layers = seen_line();
    for (const Cause cause : {Cause::cancelled, Cause::below_threshold, Cause::unexplained})
        EXPECT_EQ(layers.miss({2, 2}, cause, layers.nothing()), cause);
}

TEST(FalseNegativeCause, WithoutAPredictionIsUndeclared) {
    const Layers layers = seen_line();
    const auto found = attribute({{}, {{2, 2}}, layers.nothing()}, layers.stencils(), {}, {});
    EXPECT_THAT(found.pixels, ElementsAre(WrongPixel{{2, 2}, Cause::undeclared}));
}

TEST(FalseNegativeCause, ALineBetweenCentresOfOneTriangleIsSubPixelWhateverWasPredicted) {
    Layers layers(Rows(5, "1111111"));
    layers.cracks.right.at(2, 2) = 1;
    for (const Cause cause : {Cause::cancelled, Cause::unexplained, Cause::undeclared})
        EXPECT_EQ(layers.miss({2, 2}, cause, layers.nothing()), Cause::sub_pixel);
}

TEST(FalseNegativeCause, WhatWasDrawnInASeeingStencilWasThinnedAway) {
    const Layers layers = seen_line();
    edge::Mask drawn = layers.nothing();
    drawn.at(3, 2) = 1;
    EXPECT_EQ(layers.miss({2, 2}, Cause::unexplained, drawn), Cause::thinned);
    EXPECT_EQ(layers.miss({2, 2}, Cause::undeclared, drawn), Cause::thinned);
    EXPECT_EQ(layers.miss({2, 2}, Cause::cancelled, drawn), Cause::cancelled)
        << "a prediction does not look at the image";
    EXPECT_EQ(layers.miss({2, 2}, Cause::below_threshold, drawn), Cause::below_threshold);
    drawn.at(3, 2) = 0;
    drawn.at(1, 2) = 1;
    EXPECT_EQ(layers.miss({2, 2}, Cause::unexplained, drawn), Cause::unexplained)
        << "that stencil does not see the line";
}

TEST(Attribution, CountsWhatItLists) {
    Layers layers = seen_line();
    const WrongPixels wrong{{{0, 0}, {5, 2}, {2, 3}}, {{2, 2}, {5, 3}}, layers.nothing()};
    const Cause predicted[] = {Cause::cancelled, Cause::cancelled};
    const Attribution found = attribute(wrong, layers.stencils(), predicted, {});
    EXPECT_THAT(found.pixels,
                ElementsAre(WrongPixel{{0, 0}, Cause::frame},
                            WrongPixel{{5, 2}, Cause::one_triangle},
                            WrongPixel{{2, 3}, Cause::crack},
                            WrongPixel{{2, 2}, Cause::cancelled},
                            WrongPixel{{5, 3}, Cause::sub_pixel}));
    EXPECT_THAT(found.counts.px, ElementsAre(1, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0));
}

TEST(Attribution, NothingWrongGivesNothing) {
    const Layers layers(kTwoHalves);
    EXPECT_THAT(attribute({{}, {}, layers.nothing()}, layers.stencils(), {}, {}).pixels, IsEmpty());
}

WrongPixels wrong_of(const Image& drawn, const ScoringTruth& truth, const ScoreOptions& options) {
    const Strokes strokes = make_strokes(drawn, options.threshold, options);
    const TruthLists lists = list_truth(truth, options);
    return wrong_pixels(strokes, counted_pixels(strokes.thinned, lists), lists, options);
}

TEST(WrongPixels, AreThoseOutOfReach) {
    const Image labels = image_of({"1....", ".....", ".....", "....1"});
    const Image drawn = image_of({".#...", ".....", "#....", "....."});
    const ScoreOptions options{.tolerance_px = 1};
    const WrongPixels wrong = wrong_of(drawn, prepare_truth(labels, options, false), options);
    EXPECT_THAT(wrong.false_positives, ElementsAre(Pixel{0, 2}));
    EXPECT_THAT(wrong.false_negatives, ElementsAre(Pixel{4, 3}));
    EXPECT_EQ(wrong.drawn, image_of({".1...", ".....", "1....", "....."}));
}

TEST(WrongPixels, TheBandIsOutOfAllThree) {
    const Image labels = image_of({"1....", ".....", ".....", ".....", "....1"});
    const Image drawn = image_of({".....", "#....", ".....", "...#.", "....."});
    const ScoreOptions options{.tolerance_px = 1, .band_px = 1};
    const WrongPixels wrong = wrong_of(drawn, prepare_truth(labels, options, false), options);
    EXPECT_THAT(wrong.false_positives, ElementsAre(Pixel{3, 3}));
    EXPECT_THAT(wrong.false_negatives, IsEmpty());
    EXPECT_EQ(wrong.drawn, image_of({".....", ".....", ".....", "...1.", "....."}));
}

TEST(WrongPixels, AreAsManyAsTheScoreCounts) {
    std::mt19937 random(5);
    std::int64_t all = 0;
    for (int i = 0; i < 200; ++i) {
        const Image labels = random_image(24, 17, 0.06, 7, random);
        const Image drawn = random_image(24, 17, 0.12, 255, random);
        const ScoreOptions options{
            .tolerance_px = 1.5, .threshold = 100, .band_px = i % 3, .ignore_label = 7};
        const ScoringTruth truth = prepare_truth(labels, options, i % 2 == 0);
        const Score counted = score(drawn, truth, options);
        const WrongPixels wrong = wrong_of(drawn, truth, options);
        ASSERT_EQ(static_cast<std::int64_t>(wrong.false_positives.size()), counted.false_positives);
        ASSERT_EQ(static_cast<std::int64_t>(wrong.false_negatives.size()), counted.false_negatives);
        all += counted.false_positives + counted.false_negatives;
    }
    EXPECT_GT(all, 1000);
}

}  // namespace
}  // namespace ink::score
