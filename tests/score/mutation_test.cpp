// Faults planted in a perfect drawing, and the one number that has to see each.

#include <gtest/gtest.h>

#include "score/cracks.h"
#include "score/drawing.h"
#include "score/far_positives.h"
#include "score/line_width.h"
#include "score/offset.h"
#include "score/score.h"
#include "tests/score/curves.h"
#include "truth/cracks.h"

namespace {

using namespace ink;

constexpr int kSize_px = 120;
constexpr int kBand_px = 6;
constexpr int kLeft = 40;   ///< column of the left line
constexpr int kRight = 80;  ///< and of the right one
constexpr int kRows = kSize_px - 2 * kBand_px;

/// All that is said of an image.
struct Report {
    score::Score score;
    score::CrackScore cracks;
    score::Offsets offsets;
    score::Widths widths;
    score::PositiveCount positives;
};

/// Two upright lines from frame to frame, `width` columns wide (odd), moved by `dx`.
Image lines(int width, int dx = 0) {
    return drawn_where(kSize_px, kSize_px, [&](double x, double) {
        const auto is_on = [&](int column) {
            return std::abs(x - dx - column - 0.5) < width / 2.0;
        };
        return is_on(kLeft) || is_on(kRight);
    });
}

/// The same as true curves through the columns' centres, both empty outside: a strip's two sides.
Curves true_lines() {
    Curves curves = {curve(kLeft + 0.5, 0, kLeft + 0.5, kSize_px, truth::LineClass::contour),
                     curve(kRight + 0.5, 0, kRight + 0.5, kSize_px, truth::LineClass::contour)};
    curves[0].empty_side = 1;
    curves[1].empty_side = -1;
    return curves;
}

Report report_on(const Image& drawn, double tolerance_px) {
    const score::ScoreOptions options{
        .tolerance_px = tolerance_px, .threshold = 1, .band_px = kBand_px};
    const Curves curves = true_lines();
    const auto scoring = score::prepare_truth(lines(1), options, true);
    const auto strokes = score::make_strokes(drawn, 1, options);
    const auto thinned =
        score::counted_pixels(strokes.thinned, score::list_truth(scoring, options));
    const auto cracks = truth::draw_cracks(curves, kSize_px, kSize_px);
    return {score::score(drawn, scoring, options),
            score::score_cracks(strokes.drawn, score::prepare_cracks(cracks, scoring, options)),
            score::measure_offsets(thinned, score::find_nearest_curves(curves, kSize_px, kSize_px)),
            score::measure_widths(strokes.drawn, score::place_probes(curves, scoring, options)),
            score::count_positives(strokes.drawn, score::prepare_positives(scoring, options))};
}

TEST(Mutation, NoneScoresOne) {
    for (const double tolerance_px : {0.5, 1.0, 2.0}) {
        const Report r = report_on(lines(1), tolerance_px);
        EXPECT_EQ(r.score.n_truth, 2 * kRows);
        EXPECT_EQ(r.score.f(), 1);
        EXPECT_EQ(r.offsets.all.n, 2 * kRows);
        EXPECT_EQ(r.offsets.all.rms(), 0.0);
        EXPECT_EQ(r.widths.all.mean(), 1.0);
        EXPECT_EQ(r.positives.n_false, 0);
        EXPECT_EQ(r.cracks.f(), 1);
        EXPECT_EQ(r.cracks.all.n_truth, 2 * kRows);
    }
}

TEST(Mutation, AShiftOfOnePixelIsSeenAtHalfAPixel) {
    EXPECT_EQ(report_on(lines(1, 1), 0.5).score.f(), 0);
    const Report r = report_on(lines(1, 1), 2);
    EXPECT_EQ(r.score.f(), 1);
    EXPECT_EQ(r.cracks.f(), 0);
    // The left line has moved inwards, the right one outwards.
    EXPECT_EQ(r.offsets.all.mean(), 0.0);
    EXPECT_EQ(r.offsets.all.rms(), 1.0);
    EXPECT_EQ(r.widths.all.mean(), 1.0);
    EXPECT_EQ(r.positives.n_false, 0);
}

TEST(Mutation, AStripDrawnTooWideIsSeenByTheOffset) {
    Image drawn(kSize_px, kSize_px);
    for (int y = 0; y < kSize_px; ++y)
        drawn.at(kLeft - 1, y) = drawn.at(kRight + 1, y) = 1;
    const Report r = report_on(drawn, 2);
    EXPECT_EQ(r.score.f(), 1);
    EXPECT_EQ(r.offsets.all.mean(), 1.0);
    EXPECT_EQ(r.offsets.all.spread(), 0.0);
}

TEST(Mutation, AGhostThreePixelsBesideIsSeen) {
    Image drawn = lines(1);
    for (int y = 30; y < 90; ++y)
        drawn.at(kLeft + 3, y) = 1;
    const Report r = report_on(drawn, 2);
    EXPECT_EQ(r.score.k, 2 * kRows);
    EXPECT_EQ(r.score.false_positives, 60);
    EXPECT_EQ(r.score.n_pred, 2 * kRows + 60);
    EXPECT_EQ(r.positives.n_false, 60);
    EXPECT_EQ(r.cracks.n_drawn - r.cracks.n_beside, 60);
    EXPECT_EQ(r.cracks.recall(), 1.0);
    EXPECT_EQ(r.offsets.all.n, 2 * kRows);
    EXPECT_EQ(r.widths.all.mean(), 1.0);
}

TEST(Mutation, GapsOfAFifthAreSeen) {
    Image drawn = lines(1);
    for (int y = 0; y < kSize_px; y += 5)
        drawn.at(kLeft, y) = drawn.at(kRight, y) = 0;
    const int gaps = 2 * 21;  // rows 10, 15 .. 110 of each line
    const Report r = report_on(drawn, 2);
    EXPECT_EQ(r.score.k, 2 * kRows - gaps);
    EXPECT_EQ(r.score.n_pred, 2 * kRows - gaps);
    EXPECT_EQ(r.score.unmatched_truth, gaps);
    EXPECT_EQ(r.score.precision(), 1.0);
    EXPECT_EQ(r.cracks.all.n_truth - r.cracks.all.n_found, gaps);
    EXPECT_EQ(r.cracks.precision(), 1.0);
    EXPECT_EQ(r.offsets.all.rms(), 0.0);
    // A probe is half a pixel from a row's ends: a normal meets its own row only.
    EXPECT_EQ(r.widths.n_missed, gaps);
    EXPECT_EQ(r.widths.all.mean(), 1.0);
    EXPECT_EQ(r.positives.n_false, 0);
}

TEST(Mutation, WidthIsSeenByWidthAndNotByF) {
    const Report three = report_on(lines(3), 2);
    const Report five = report_on(lines(5), 2);
    for (const Report& r : {three, five}) {
        EXPECT_EQ(r.score.f(), 1);
        EXPECT_EQ(r.score.k, 2 * kRows);
        EXPECT_EQ(r.offsets.all.rms(), 0.0);
        EXPECT_EQ(r.widths.all.spread(), 0.0);
        EXPECT_EQ(r.positives.n_false, 0);
        EXPECT_EQ(r.cracks.recall(), 1.0);
    }
    EXPECT_EQ(three.widths.all.mean(), 3.0);
    EXPECT_EQ(five.widths.all.mean(), 5.0);
    EXPECT_NEAR(three.score.mean_width_px, 3, 0.1);
    EXPECT_NEAR(five.score.mean_width_px, 5, 0.2);
    EXPECT_EQ(three.cracks.precision(), 2.0 / 3);
    EXPECT_EQ(five.cracks.precision(), 2.0 / 5);
}

}  // namespace
