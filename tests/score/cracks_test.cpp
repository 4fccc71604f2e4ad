#include "score/cracks.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/score/images.h"

namespace {

using ink::score::CrackScore;
using ink::score::prepare_truth;
using ink::score::ScoreOptions;
using ink::truth::Cracks;

Cracks no_cracks(int width_px, int height_px) {
    return {Image(width_px, height_px), Image(width_px, height_px)};
}

/// Cracks of an upright line of a class between columns x and x + 1, rows first..last.
void add_upright(Cracks& cracks, int x, int first, int last, std::uint8_t label = 1) {
    for (int y = first; y <= last; ++y)
        cracks.right.at(x, y) = label;
}

Image upright(int width_px, int height_px, std::vector<int> columns) {
    Image image(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        for (const int x : columns)
            image.at(x, y) = 1;
    }
    return image;
}

CrackScore score_of(const Image& drawn,
                    const Cracks& cracks,
                    const Image& labels,
                    const ScoreOptions& options = {}) {
    const auto truth = prepare_truth(labels, options, false);
    return ink::score::score_cracks(drawn, prepare_cracks(cracks, truth, options));
}

CrackScore score_of(const Image& drawn, const Cracks& cracks) {
    return score_of(drawn, cracks, Image(drawn.width_px(), drawn.height_px()));
}

TEST(CrackScore, ALineOnEitherSideOfTheCracksIsInItsPlace) {
    Cracks cracks = no_cracks(12, 9);
    add_upright(cracks, 5, 0, 8);
    for (const std::vector<int>& columns : {std::vector{5}, std::vector{6}, std::vector{5, 6}}) {
        const CrackScore s = score_of(upright(12, 9, columns), cracks);
        EXPECT_EQ(s.precision(), 1.0);
        EXPECT_EQ(s.recall(), 1.0);
        EXPECT_EQ(s.f(), 1.0);
    }
}

TEST(CrackScore, ALineOnePixelFurtherOnIsNot) {
    Cracks cracks = no_cracks(12, 9);
    add_upright(cracks, 5, 0, 8);
    for (const int x : {4, 7}) {
        const CrackScore s = score_of(upright(12, 9, {x}), cracks);
        EXPECT_EQ(s.precision(), 0.0);
        EXPECT_EQ(s.recall(), 0.0);
        EXPECT_EQ(s.f(), 0.0);
    }
}

TEST(CrackScore, FatLinesPayInPrecisionOnly) {
    Cracks cracks = no_cracks(12, 9);
    add_upright(cracks, 5, 0, 8);
    const CrackScore s = score_of(upright(12, 9, {4, 5, 6, 7}), cracks);
    EXPECT_EQ(s.precision(), 0.5);
    EXPECT_EQ(s.recall(), 1.0);
    EXPECT_DOUBLE_EQ(s.f(), 2.0 / 3);
}

TEST(CrackScore, GapsPayInRecallOnly) {
    Cracks cracks = no_cracks(12, 10);
    add_upright(cracks, 5, 0, 9);
    Image drawn = upright(12, 10, {5});
    drawn.at(5, 3) = drawn.at(5, 4) = 0;
    const CrackScore s = score_of(drawn, cracks);
    EXPECT_EQ(s.precision(), 1.0);
    EXPECT_EQ(s.recall(), 0.8);
}

TEST(CrackScore, OfALevelLineTakesTheCracksBelow) {
    Cracks cracks = no_cracks(9, 12);
    for (int x = 0; x < 9; ++x)
        cracks.below.at(x, 5) = 3;
    for (const int y : {4, 5, 6, 7}) {
        Image drawn(9, 12);
        for (int x = 0; x < 9; ++x)
            drawn.at(x, y) = 1;
        EXPECT_EQ(score_of(drawn, cracks).f(), y == 5 || y == 6 ? 1.0 : 0.0) << y;
    }
}

TEST(CrackScore, HasARecallPerClass) {
    Cracks cracks = no_cracks(20, 10);
    add_upright(cracks, 4, 0, 9, 1);
    add_upright(cracks, 12, 0, 4, 3);
    Image drawn = upright(20, 10, {5});
    drawn.at(12, 0) = 1;
    const CrackScore s = score_of(drawn, cracks);
    EXPECT_EQ(s.classes[1].n_truth, 10);
    EXPECT_EQ(s.classes[1].n_found, 10);
    EXPECT_EQ(s.classes[3].n_truth, 5);
    EXPECT_EQ(s.classes[3].n_found, 1);
    EXPECT_EQ(s.all.n_truth, 15);
    EXPECT_EQ(s.all.n_found, 11);
}

TEST(CrackScore, LeavesTheBandOut) {
    Cracks cracks = no_cracks(12, 9);
    add_upright(cracks, 5, 0, 8);
    add_upright(cracks, 1, 0, 8);  // its right pixels, in column 2, are not in the band
    const Image labels(12, 9);
    const CrackScore s = score_of(upright(12, 9, {0, 2, 5}), cracks, labels, {.band_px = 2});
    // Rows 2..6. Column 0 is not asked; cracks into the band are not asked for; column 2 is right.
    EXPECT_EQ(s.all.n_truth, 5);
    EXPECT_EQ(s.all.n_found, 5);
    EXPECT_EQ(s.n_drawn, 10);
    EXPECT_EQ(s.n_beside, 10);
}

TEST(CrackScore, LeavesIgnoredPixelsOut) {
    Cracks cracks = no_cracks(12, 3);
    add_upright(cracks, 3, 0, 2);
    Image labels(12, 3);
    for (int y = 0; y < 3; ++y)
        labels.at(4, y) = labels.at(5, y) = 7;
    const ScoreOptions options{.ignore_label = 7};
    const auto counts = [&](int x) {
        const CrackScore s = score_of(upright(12, 3, {x}), cracks, labels, options);
        return std::vector<std::int64_t>{s.all.n_truth, s.n_drawn, s.n_beside};
    };
    using Counts = std::vector<std::int64_t>;
    EXPECT_EQ(counts(3), (Counts{0, 3, 3}));  // beside a crack that is not asked for
    EXPECT_EQ(counts(4), (Counts{0, 0, 0}));  // ignored itself
    EXPECT_EQ(counts(6), (Counts{0, 0, 0}));  // beside ignored pixels, no crack
    EXPECT_EQ(counts(7), (Counts{0, 3, 0}));
}

TEST(CrackScore, OfNothingIsNoNumber) {
    const Cracks none = no_cracks(6, 5);
    Cracks some = no_cracks(6, 5);
    add_upright(some, 2, 0, 4);
    const CrackScore both = score_of(Image(6, 5), none);
    EXPECT_FALSE(both.precision().has_value());
    EXPECT_FALSE(both.recall().has_value());
    EXPECT_EQ(both.f(), 1);
    const CrackScore no_drawing = score_of(Image(6, 5), some);
    EXPECT_FALSE(no_drawing.precision().has_value());
    EXPECT_EQ(no_drawing.recall(), 0.0);
    EXPECT_EQ(no_drawing.f(), 0);
    const CrackScore no_truth = score_of(upright(6, 5, {2}), none);
    EXPECT_EQ(no_truth.precision(), 0.0);
    EXPECT_FALSE(no_truth.recall().has_value());
    EXPECT_EQ(no_truth.f(), 0);
    EXPECT_EQ(score_of(Image(), no_cracks(0, 0)).f(), 1);
}

TEST(CrackScore, RefusesAnotherSize) {
    EXPECT_THROW(static_cast<void>(score_of(Image(6, 5), no_cracks(5, 6), Image(5, 6))),
                 ink::core::Error);
}

}  // namespace
