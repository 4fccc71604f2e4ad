#include "score/score.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "edge/thin.h"
#include "tests/score/images.h"

namespace {

using ink::score::CurveCount;
using ink::score::prepare_truth;
using ink::score::Score;
using ink::score::ScoreOptions;
using ink::score::ScoringTruth;

Score score_of(const Image& prediction, const Image& labels, const ScoreOptions& options = {}) {
    return ink::score::score(prediction, prepare_truth(labels, options, false), options);
}

/// k, n_pred, n_truth, surplus, false_positives, lost, missing.
std::vector<std::int64_t> counts_of(const Score& s) {
    return {s.k,
            s.n_pred,
            s.n_truth,
            s.unmatched_duplicates,
            s.false_positives,
            s.unmatched_truth,
            s.false_negatives};
}
using Counts = std::vector<std::int64_t>;

TEST(Score, OfAShiftedLineIsFullWithinTheTolerance) {
    const Image truth = image_of({"........", ".######.", "........", "........", "........"});
    const Image shifted = image_of({"........", "........", "........", ".######.", "........"});
    EXPECT_EQ(counts_of(score_of(shifted, truth, {.tolerance_px = 2})),
              (Counts{6, 6, 6, 0, 0, 0, 0}));
    EXPECT_EQ(counts_of(score_of(shifted, truth, {.tolerance_px = 1})),
              (Counts{0, 6, 6, 0, 6, 0, 6}));
}

TEST(Score, OfADoubledLineCountsTheDoubleAsUnmatchedDuplicates) {
    const Image truth = image_of({"......", "......", "######", "......", "......"});
    const Image doubled = image_of({"......", "######", "......", "######", "......"});
    const Score s = score_of(doubled, truth);
    EXPECT_EQ(counts_of(s), (Counts{6, 12, 6, 6, 0, 0, 0}));
    EXPECT_DOUBLE_EQ(s.f(), 12.0 / 18.0);
    EXPECT_DOUBLE_EQ(s.precision().value(), 0.5);
    EXPECT_DOUBLE_EQ(s.recall().value(), 1);
}

TEST(Score, OfABrokenLineTellsUnmatchedTruthFromFalseNegatives) {
    const Image truth = image_of({"##########"});
    const Image broken = image_of({"#........."});
    // The lone pixel takes one of the three within 2 px; the others of these are lost in
    // competition.
    EXPECT_EQ(counts_of(score_of(broken, truth)), (Counts{1, 1, 10, 0, 0, 2, 7}));
}

TEST(Score, ThinsThePredictionAndTellsItsWidth) {
    const Image truth =
        image_of({"..........", "..........", ".########.", "..........", ".........."});
    const Image fat =
        image_of({"..........", ".########.", ".########.", ".########.", ".........."});
    const Score thinned = score_of(fat, truth);
    EXPECT_LT(thinned.n_pred, 9);
    EXPECT_GE(thinned.n_pred, 6);
    EXPECT_DOUBLE_EQ(thinned.mean_width_px, 24.0 / static_cast<double>(thinned.n_pred));
    const Score raw = score_of(fat, truth, {.thin = false});
    EXPECT_EQ(counts_of(raw), (Counts{8, 24, 8, 16, 0, 0, 0}));
    EXPECT_DOUBLE_EQ(raw.mean_width_px, 1);
}

TEST(Score, NeverThinsAForeignTruth) {
    const Image fat = image_of({"......", ".####.", ".####.", "......"});
    EXPECT_EQ(score_of(fat, fat).n_truth, 8);
}

TEST(Score, CountsFromTheThresholdUp) {
    const Image truth = image_of({"1.1.1"});
    const Image edge_responses = image_of({"1.2.3"}, 50);
    EXPECT_EQ(score_of(edge_responses, truth, {.tolerance_px = 1, .threshold = 100}).k, 2);
    EXPECT_EQ(score_of(edge_responses, truth, {.tolerance_px = 1, .threshold = 101}).k, 1);
}

TEST(Score, TakesTheBandOutOfBothSetsAfterThinning) {
    // Of a bar 3 px wide at the frame the middle column stays, which lies in a band of 2.
    const Image bar(3, 9, 255);
    Image drawn(9, 9);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 3; ++x)
            drawn.at(x, y) = 255;
    }
    const Image truth = image_of({"1........",
                                  "1........",
                                  "1........",
                                  "1........",
                                  "1...1....",
                                  "1........",
                                  "1........",
                                  "1........",
                                  "1........"});
    EXPECT_GT(score_of(drawn, truth).n_pred, 0);
    EXPECT_EQ(counts_of(score_of(drawn, truth, {.band_px = 2})), (Counts{0, 0, 1, 0, 0, 0, 1}));
}

TEST(Score, ABandWiderThanTheImageLeavesNothing) {
    const Image full(5, 4, 255);
    EXPECT_EQ(counts_of(score_of(full, full, {.band_px = 3})), (Counts{0, 0, 0, 0, 0, 0, 0}));
}

TEST(Score, DropsWhatLiesNearIgnoreAndNowhereNearTruth) {
    const Image truth = image_of({"7......1..",  //
                                  "7.....7...",
                                  "7........."});
    const Image drawn = image_of({"..........",  //
                                  ".#...#...#",
                                  ".........."});
    // The truth pixel is 2.24 px from the second and from the third drawn pixel, ignore 1 px from
    // the first and second and 3 px from the third.
    EXPECT_EQ(
        counts_of(score_of(drawn, truth, {.tolerance_px = 2, .thin = false, .ignore_label = 7})),
        (Counts{0, 1, 1, 0, 1, 0, 1}));
    EXPECT_EQ(
        counts_of(score_of(drawn, truth, {.tolerance_px = 2.5, .thin = false, .ignore_label = 7})),
        (Counts{1, 2, 1, 1, 0, 0, 0}));
}

TEST(Score, GivesEachClassAMatchingOfItsOwn) {
    // One pixel within reach of two classes: either recall is full, though only one can be matched.
    const Image truth = image_of({"1..", "...", "..2"});
    const Image dot = image_of({"...", ".#.", "..."});
    const Score s = score_of(dot, truth);
    EXPECT_EQ(counts_of(s), (Counts{1, 1, 2, 0, 0, 1, 0}));
    ASSERT_EQ(s.classes.size(), 2U);
    EXPECT_EQ(s.classes[0].label, 1);
    EXPECT_EQ(s.classes[0].k, 1);
    EXPECT_EQ(s.classes[1].label, 2);
    EXPECT_EQ(s.classes[1].k, 1);
    EXPECT_EQ(s.classes[1].n_truth, 1);
}

TEST(PrepareTruth, ReadsALoneOneOr255AsNoClass) {
    const auto is_binary = [](const Rows& rows, const ScoreOptions& options) {
        return prepare_truth(image_of(rows), options, false).is_binary;
    };
    EXPECT_TRUE(is_binary({"..."}, {}));
    EXPECT_TRUE(is_binary({"1.1"}, {}));
    EXPECT_TRUE(is_binary({"#.#"}, {}));
    EXPECT_FALSE(is_binary({"1.#"}, {}));
    EXPECT_FALSE(is_binary({"2.2"}, {}));
    EXPECT_FALSE(is_binary({"1.7"}, {}));
    EXPECT_TRUE(is_binary({"1.7"}, {.ignore_label = 7}));
}

TEST(PrepareTruth, OfALoneOneScoresItAsAClassIfToldSo) {
    const Image line = image_of({"111"});
    ScoringTruth truth = prepare_truth(line, {}, true);
    truth.is_binary = false;
    const Score s = ink::score::score(image_of({"###"}), truth, {});
    ASSERT_EQ(s.classes.size(), 1U);
    EXPECT_EQ(s.classes[0].k, 3);
}

TEST(PrepareTruth, TakesIgnoreOutBeforeItThins) {
    // The row of ignore makes the line two wide; without it nothing is left to thin.
    const Image labels = image_of({"......", "111111", "777777", "......"});
    const ScoringTruth truth = prepare_truth(labels, {.ignore_label = 7}, true);
    EXPECT_EQ(truth.labels, image_of({"......", "111111", "......", "......"}));
    EXPECT_EQ(truth.ignore, image_of({"......", "......", "111111", "......"}));
}

TEST(PrepareTruth, RethinnedScoresExactlyOneAgainstItself) {
    std::mt19937 random(21);
    for (int i = 0; i < 100; ++i) {
        const Image labels = random_image(60, 40, (i % 10 + 0.5) / 10, 7, random);
        const ScoreOptions options{
            .tolerance_px = 1.0 + i % 3, .band_px = i % 7, .ignore_label = 7};
        const ScoringTruth truth = prepare_truth(labels, options, true);
        Image drawn = truth.labels;
        for (std::size_t p = 0; p < drawn.size(); ++p)
            drawn.data()[p] = drawn.data()[p] != 0 ? 255 : 0;
        const Score s = ink::score::score(drawn, truth, options);
        ASSERT_EQ(s.k, s.n_truth) << "truth " << i;
        ASSERT_EQ(s.k, s.n_pred) << "truth " << i;
        ASSERT_EQ(s.f(), 1.0) << "truth " << i;
    }
}

TEST(ScoreLaws, EveryPixelIsCountedOnceAndATighterToleranceNeverGainsOne) {
    std::mt19937 random(22);
    for (int i = 0; i < 60; ++i) {
        const Image drawn = random_image(50, 40, 0.02 * (1 + i % 12), 255, random);
        const Image labels = random_image(50, 40, 0.10, 4, random);
        std::int64_t k_before = 0;
        for (const double tolerance_px : {1.0, 1.5, 2.0, 3.0, 4.0}) {
            const Score s =
                score_of(drawn, labels, {.tolerance_px = tolerance_px, .threshold = 100});
            ASSERT_EQ(s.n_pred, s.k + s.unmatched_duplicates + s.false_positives);
            ASSERT_EQ(s.n_truth, s.k + s.unmatched_truth + s.false_negatives);
            for (const std::int64_t n : counts_of(s))
                ASSERT_GE(n, 0);
            ASSERT_GE(s.k, k_before);
            k_before = s.k;
            std::int64_t n_of_classes = 0;
            for (const auto& c : s.classes) {
                ASSERT_LE(c.k, c.n_truth);
                n_of_classes += c.n_truth;
            }
            ASSERT_EQ(n_of_classes, s.n_truth);
        }
    }
}

TEST(ScoreLaws, UnthinnedItIsSymmetricAndBlindToTransposition) {
    std::mt19937 random(23);
    for (int i = 0; i < 60; ++i) {
        const Image a = random_image(50, 30, 0.15, 1, random);
        const Image b = random_image(50, 30, 0.05 + 0.005 * i, 1, random);
        const ScoreOptions options{.threshold = 1, .thin = false};
        const Score there = score_of(a, b, options);
        const Score back = score_of(b, a, options);
        const Counts swapped = {back.k,
                                back.n_truth,
                                back.n_pred,
                                back.unmatched_truth,
                                back.false_negatives,
                                back.unmatched_duplicates,
                                back.false_positives};
        ASSERT_EQ(counts_of(there), swapped);
        ASSERT_EQ(counts_of(there), counts_of(score_of(transposed(a), transposed(b), options)));
    }
}

TEST(Degenerate, EmptyImagesGiveFullOrNoScoreAndNoNumberWhereThereIsNone) {
    const Image empty(12, 9);
    const Image line = image_of({"............",
                                 ".#########..",
                                 "............",
                                 "............",
                                 "............",
                                 "............",
                                 "............",
                                 "............",
                                 "............"});
    const Score both = score_of(empty, empty);
    EXPECT_EQ(both.f(), 1);
    EXPECT_FALSE(both.precision().has_value());
    EXPECT_FALSE(both.recall().has_value());
    EXPECT_EQ(both.mean_width_px, 0);

    const Score no_prediction = score_of(empty, line);
    EXPECT_EQ(no_prediction.f(), 0);
    EXPECT_FALSE(no_prediction.precision().has_value());
    EXPECT_EQ(no_prediction.recall(), 0.0);

    const Score no_truth = score_of(line, empty);
    EXPECT_EQ(no_truth.f(), 0);
    EXPECT_EQ(no_truth.precision(), 0.0);
    EXPECT_FALSE(no_truth.recall().has_value());

    EXPECT_EQ(score_of(Image(), Image()).f(), 1);
}

TEST(Refused, SizesThatDifferAreBothNamed) {
    try {
        static_cast<void>(score_of(Image(4, 3), Image(3, 4)));
        FAIL() << "not refused";
    } catch (const ink::core::Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("4 x 3"));
        EXPECT_THAT(error.what(), testing::HasSubstr("3 x 4"));
    }
}

TEST(Refused, OptionsOutsideTheirRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double tolerance_px : {0.0, -1.0, 8.5, nan, infinity}) {
        EXPECT_THROW(ink::score::check({.tolerance_px = tolerance_px}), ink::core::Error);
    }
    for (const int threshold : {-1, 0, 256}) {
        EXPECT_THROW(ink::score::check({.threshold = threshold}), ink::core::Error);
    }
    EXPECT_THROW(ink::score::check({.band_px = -1}), ink::core::Error);
    for (const int label : {0, 256, -7}) {
        EXPECT_THROW(ink::score::check({.ignore_label = label}), ink::core::Error);
    }
    EXPECT_NO_THROW(ink::score::check({.tolerance_px = 8, .threshold = 255, .ignore_label = 255}));
}

}  // namespace
