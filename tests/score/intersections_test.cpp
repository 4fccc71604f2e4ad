#include "score/intersections.h"

#include <gtest/gtest.h>

namespace ink::score {
namespace {

using truth::LineClass;

TEST(Intersections, FlatOnesAreIgnoredUnlessAllCount) {
    core::Image<std::uint8_t> labels(3, 1);
    labels.at(0, 0) = 4;
    labels.at(1, 0) = 4;
    labels.at(2, 0) = 1;
    core::Image<std::uint8_t> below(3, 1);
    below.at(1, 0) = 1;
    const auto above = counted_labels(labels, below, Intersections::above_crease);
    EXPECT_EQ(above.at(0, 0), 4);
    EXPECT_EQ(above.at(1, 0), 7);
    EXPECT_EQ(above.at(2, 0), 1);
    EXPECT_EQ(counted_labels(labels, below, Intersections::all), labels);
}

TEST(Intersections, CountedCurvesAreThoseOfTheChoice) {
    std::vector<truth::Curve> curves(3);
    curves[0].line_class = LineClass::intersection;
    curves[0].deviation_rad = 0.5F;
    curves[1].line_class = LineClass::intersection;
    curves[1].deviation_rad = 0.9F;
    curves[2].line_class = LineClass::seam;
    EXPECT_EQ(counted_curves(curves, 0.7, Intersections::above_crease).size(), 2U);
    EXPECT_EQ(counted_curves(curves, 0.7, Intersections::all).size(), 3U);
    EXPECT_EQ(counted_curves(curves, 0, Intersections::above_crease).size(), 3U);
}

}  // namespace
}  // namespace ink::score
