#include "harness/scores/bins.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "harness/rows/row.h"

namespace ink::harness {
namespace {

using truth::Curve;
using truth::LineClass;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegree = std::numbers::pi / 180;

/// A level curve along the centres of a row, as long as `n` pixels from x = 10 on.
Curve level(LineClass line_class, int row, int n, double w) {
    Curve curve;
    curve.line_class = line_class;
    curve.begin = {10.5, row + 0.5, w};
    curve.end = {10.5 + n - 1, row + 0.5, w};
    return curve;
}

/// A truth of these curves, without band and ignore.
struct Made {
    truth::Truth traced;
    score::ScoringTruth scoring;
};

Made truth_of(const std::vector<Curve>& curves) {
    Made made;
    made.traced.curves = curves;
    core::Image<std::uint8_t> labels(100, 100);
    for (const Curve& c : curves) {
        for (int x = 10; x + 0.5 <= c.end.x_px; ++x)
            labels.at(x, static_cast<int>(c.begin.y_px)) = static_cast<std::uint8_t>(c.line_class);
    }
    made.scoring = score::prepare_truth(labels, {}, true);
    return made;
}

/// The bins of one attribute: low, high, pixels.
using Bin = std::tuple<double, double, std::size_t>;
std::vector<Bin> bins_of(const std::vector<Curve>& curves, std::size_t attribute) {
    const Made made = truth_of(curves);
    std::vector<Bin> bins;
    for (const TruthBin& bin : bin_truth(made.traced, made.scoring)) {
        if (bin.attribute == attribute) bins.emplace_back(bin.low, bin.high, bin.pixels.size());
    }
    return bins;
}

TEST(Bins, OfDihedralsLeaveBoundariesOut) {
    std::vector<Curve> curves = {level(LineClass::contour, 10, 5, 1),
                                 level(LineClass::crease, 20, 6, 1),
                                 level(LineClass::crease, 30, 7, 1),
                                 level(LineClass::crease, 40, 8, 1),
                                 level(LineClass::boundary, 50, 9, 1)};
    curves[0].deviation_rad = static_cast<float>(5 * kDegree);
    curves[1].deviation_rad = static_cast<float>(90.001 * kDegree);
    curves[2].deviation_rad = static_cast<float>(89.999 * kDegree);
    curves[3].deviation_rad = std::numbers::pi_v<float>;
    EXPECT_EQ(bins_of(curves, 0),
              (std::vector<Bin>{{0, 20, 5}, {60, 90, 7}, {90, 120, 6}, {120, 180, 8}}));
}

TEST(Bins, OfGapsAreRelativeAndHaveTheSkyApart) {
    std::vector<Curve> curves = {level(LineClass::contour, 10, 5, 10),
                                 level(LineClass::contour, 20, 6, 10),
                                 level(LineClass::boundary, 30, 7, 10),
                                 level(LineClass::boundary, 40, 8, 10),
                                 level(LineClass::crease, 50, 9, 10)};
    curves[0].gap = 0.05F;  // 0.005 of the distance
    curves[1].gap = 0.5F;
    curves[2].gap = 200;
    curves[3].gap = std::numeric_limits<float>::infinity();
    EXPECT_EQ(bins_of(curves, 1),
              (std::vector<Bin>{
                  {0, 0.01, 5}, {0.03, 0.1, 6}, {0.3, kInfinity, 7}, {kInfinity, kInfinity, 8}}));
}

TEST(Bins, OfViewAnglesGoUpToEdgeOn) {
    std::vector<Curve> curves = {level(LineClass::contour, 10, 5, 1),
                                 level(LineClass::crease, 20, 6, 1),
                                 level(LineClass::seam, 30, 7, 1)};
    curves[0].view_angle_rad = 1.5707965F;  // a little over 90 degrees, by rounding
    curves[1].view_angle_rad = static_cast<float>(59.9 * kDegree);
    EXPECT_EQ(bins_of(curves, 2), (std::vector<Bin>{{0, 30, 7}, {30, 60, 6}, {85, 90, 5}}));
}

TEST(Bins, OfDistanceReachFromTheNearestLineToTheFarthest) {
    // w = 2, 3 and 12: 0, 0.1 and 1 of the way.
    const std::vector<Curve> curves = {level(LineClass::contour, 10, 5, 2),
                                       level(LineClass::contour, 20, 6, 3),
                                       level(LineClass::contour, 30, 7, 12)};
    EXPECT_EQ(bins_of(curves, 3), (std::vector<Bin>{{0, 0.2, 11}, {0.8, 1, 7}}));
    EXPECT_EQ(bins_of({level(LineClass::contour, 10, 5, 2)}, 3), (std::vector<Bin>{{0, 0.2, 5}}));
}

TEST(Bins, OfDistanceFollowALineIntoTheDepth) {
    // From w = 1 at x = 10.5 to w = 3 at 69.5; w = 1 / (1 - s 2/3) passes 1.4, 1.8, 2.2, 2.6 (0.2,
    // 0.4 ... of the way) at s = 3/7, 2/3, 9/11, 12/13: after 25.3, 39.3, 48.3 and 54.5 pixels.
    Curve line = level(LineClass::crease, 10, 60, 1);
    line.end.w = 3;
    EXPECT_EQ(bins_of({line}, 3),
              (std::vector<Bin>{
                  {0, 0.2, 26}, {0.2, 0.4, 14}, {0.4, 0.6, 9}, {0.6, 0.8, 6}, {0.8, 1, 5}}));
}

TEST(Bins, AreMatchedEachAlone) {
    std::vector<Curve> curves = {level(LineClass::crease, 10, 20, 2),
                                 level(LineClass::crease, 13, 20, 12)};
    const Made made = truth_of(curves);
    // One line between the two, within 2 px of both, half as long.
    core::Image<std::uint8_t> drawn(100, 100);
    for (int x = 10; x < 20; ++x)
        drawn.at(x, 12) = 1;
    const score::PixelList pixels(drawn);
    const auto matched = [&](double tolerance_px) {
        score::DrawnMatcher matcher(pixels, score::Disk(tolerance_px));
        return match_bins(matcher, bin_truth(made.traced, made.scoring));
    };
    const auto counts = matched(1);
    std::vector<std::tuple<std::size_t, double, std::int64_t, std::int64_t>> distances;
    for (const BinCount& c : counts) {
        if (c.attribute == 3) distances.emplace_back(c.attribute, c.low, c.k, c.n_truth);
    }
    using Line = std::tuple<std::size_t, double, std::int64_t, std::int64_t>;
    EXPECT_EQ(distances, (std::vector<Line>{{3, 0, 0, 20}, {3, 0.8, 10, 20}}));
    const auto wide = matched(2);
    // Both find ten: what one bin takes is not taken from the other.
    EXPECT_EQ(wide.back().k, 10);
    EXPECT_EQ(wide[wide.size() - 2].k, 10);
}

TEST(Bins, HaveRisingEdges) {
    ASSERT_EQ(line_attributes().size(), 4U);
    for (const LineAttribute& a : line_attributes()) {
        EXPECT_THAT(a.edges.size(), testing::AllOf(testing::Ge(6U), testing::Le(7U))) << a.name;
        EXPECT_TRUE(std::is_sorted(a.edges.begin(), a.edges.end())) << a.name;
    }
}

}  // namespace
}  // namespace ink::harness
