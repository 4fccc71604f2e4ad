#include "crosscheck/dense_sampling.h"

#include <numbers>

#include "tests/truth/shapes.h"

namespace ink::crosscheck {
namespace {

// A line's crossings are counted, not measured: over n of them the length is good to a few.
constexpr double kPx = 0.5;  ///< every expected length holds to this, and
constexpr double kShare = 0.003;

SampledLines look(const scene::Scene& scene, const scene::View& view, int threads = 1) {
    SamplingOptions options;
    options.threads = threads;
    return sample_lines(scene::weld(scene), view, options);
}

std::map<truth::LineClass, double> lengths(const SampledLines& crosscheck) {
    std::map<truth::LineClass, double> sum;
    for (const SampledPoint& p : crosscheck.points)
        sum[p.line_class] += p.length_px;
    return sum;
}

void expect_length(const SampledLines& crosscheck,
                   truth::LineClass line_class,
                   double expected_px) {
    EXPECT_NEAR(lengths(crosscheck)[line_class], expected_px, kPx + kShare * expected_px)
        << truth::name(line_class);
}

TEST(SampledLines, SeesNothingAcrossASlitOfTheWeldTolerance) {
    // The tiles lie a third of the tolerance (1e-6 of a diagonal of 2.8) apart, in one object.
    scene::Mesh mesh;
    truth::add_quad(mesh, {-1, -1, 0}, {-1e-6F, -1, 0}, {-1e-6F, 1, 0}, {-1, 1, 0});
    truth::add_quad(mesh, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0});
    const SampledLines crosscheck = look(truth::scene_of({mesh}), truth::view_from(6));
    expect_length(crosscheck, truth::LineClass::boundary, 800);
    EXPECT_EQ(lengths(crosscheck).size(), 1U);
}

/// A box sunk into a floor whose top lies `step` above it, or in its plane, in one object.
scene::Scene sunk_box(float step) {
    scene::Mesh mesh = truth::box({-1, -1, -1}, {1, 0, 1});
    truth::add_quad(mesh, {-2, -step, 2}, {2, -step, 2}, {2, -step, -2}, {-2, -step, -2});
    return truth::scene_of({mesh});
}

TEST(SampledLines, SeesNothingWhereABoxIsLevelWithItsFloor) {
    // The eye stands beyond the wall x = 1: its rim is an edge whose both faces turn to the eye,
    // though the floor covers the wall.
    const SampledLines crosscheck = look(sunk_box(0), truth::view_from({4, 6, 0.5}, {0, 0, 0}));
    EXPECT_GT(lengths(crosscheck)[truth::LineClass::boundary], 500) << "the floor's";
    EXPECT_EQ(lengths(crosscheck).size(), 1U);
}

TEST(SampledLines, SeesARimAndItsFootBetweenTwoSamples) {
    // A step of 1e-5 is a thousandth of a px: the rim of the wall x = 1 is a crease, its foot an
    // intersection; the other walls are turned away.
    const scene::View view = truth::view_from({4, 6, 0.5}, {0, 0, 0});
    const SampledLines crosscheck = look(sunk_box(1e-5F), view);
    const glm::dvec3 a(1, 0, 1), b(1, 0, -1), c(-1, 0, -1), d(-1, 0, 1);
    expect_length(crosscheck, truth::LineClass::crease, truth::length_px(view, a, b));
    expect_length(crosscheck, truth::LineClass::intersection, truth::length_px(view, a, b));
    expect_length(
        crosscheck,
        truth::LineClass::contour,
        truth::length_px(view, b, c) + truth::length_px(view, c, d) + truth::length_px(view, d, a));
}

TEST(SampledLines, SeesBothSidesOfAGapBetweenTwoSamples) {
    // Two boxes with level fronts, 1e-5 or a thousandth of a px apart, above the weld tolerance.
    // The eye stands to the left: the right side of the left box is turned away.
    constexpr float kGap = 1e-5F;
    const scene::View view = truth::view_from({-3, 0, 6}, {0, 0, 0});
    const SampledLines crosscheck = look(truth::scene_of({truth::box({-1, -1, -1}, {0, 1, 0}),
                                                          truth::box({kGap, -1, -1}, {1, 1, 0})}),
                                         view);
    const auto across = [&](double x, double z) {
        return truth::length_px(view, {x, -1, z}, {x, 1, z});
    };
    const double along = truth::length_px(view, {-1, 1, 0}, {0, 1, 0}) +
                         truth::length_px(view, {0, 1, 0}, {1, 1, 0});
    const double side = truth::length_px(view, {-1, 1, -1}, {-1, 1, 0});
    expect_length(crosscheck, truth::LineClass::crease, across(-1, 0) + across(kGap, 0));
    expect_length(crosscheck,
                  truth::LineClass::contour,
                  across(0, 0) + across(-1, -1) + across(1, 0) + 2 * along + 2 * side);
}

TEST(SampledLines, SeesASpikeThinnerThanItsSamples) {
    // One unit is 100 px: the spike is 0.1 px wide at its foot and 100 px long. Its last 2 px are
    // narrower than the distance of two looks.
    scene::Mesh mesh;
    truth::add_triangle(mesh, {-0.0005F, -0.5F, 0}, {0.0005F, -0.5F, 0}, {0, 0.5F, 0});
    const SampledLines crosscheck = look(truth::scene_of({mesh}), truth::view_from(6));
    EXPECT_GT(lengths(crosscheck)[truth::LineClass::boundary], 196);
    EXPECT_GT(crosscheck.counts.probes, 400U);
}

TEST(SampledLines, SeesBarsBetweenTwoSamplesOfOnePanel) {
    // 100 px a unit: thirty bars .08 px wide and 200 px long before a panel. All but three pass
    // between the columns of pixel samples, which see the panel on both sides of them.
    constexpr int kBars = 30;
    constexpr float kWidth = 0.0008F, kSpacing = 0.0503F;
    scene::Mesh panel, bars;
    truth::add_quad(
        panel, {-1.5F, -1.5F, -1}, {1.5F, -1.5F, -1}, {1.5F, 1.5F, -1}, {-1.5F, 1.5F, -1});
    for (int i = 0; i < kBars; ++i) {
        const float x = kSpacing * (static_cast<float>(i) - 14.5F);
        truth::add_quad(bars, {x, -1, 0}, {x + kWidth, -1, 0}, {x + kWidth, 1, 0}, {x, 1, 0});
    }
    const SampledLines crosscheck = look(truth::scene_of({panel, bars}), truth::view_from(6));
    expect_length(crosscheck,
                  truth::LineClass::boundary,
                  kBars * 2 * (200 + 0.08) + 4 * 3 * truth::kFocal_px / 7);
    EXPECT_EQ(lengths(crosscheck).size(), 1U);
}

TEST(SampledLines, TheNearPlaneDrawsNoLine) {
    // A floor that the near plane cuts, filling the frame's lower half: its far border alone shows.
    scene::Mesh mesh;
    truth::add_quad(mesh, {-50, -1, 5}, {50, -1, 5}, {50, -1, -44}, {-50, -1, -44});
    const SampledLines crosscheck = look(truth::scene_of({mesh}), truth::view_from(6, 4));
    // At distance 50 the image is 640 px wide, all of which the border crosses.
    expect_length(crosscheck, truth::LineClass::boundary, 640);
}

TEST(SampledLines, IsTheSameOnEveryThreadCount) {
    const scene::Scene scene =
        truth::scene_of({truth::box({-1, -1, -1}, {1, 1, 1}), truth::box({0, 0, 0}, {2, 2, 2})});
    const scene::View view = truth::view_from({3, 4, 7}, {0, 0, 0});
    const SampledLines one = look(scene, view, 1), three = look(scene, view, 3);
    ASSERT_EQ(one.points.size(), three.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
        EXPECT_EQ(one.points[i].x_px, three.points[i].x_px);
        EXPECT_EQ(one.points[i].y_px, three.points[i].y_px);
        EXPECT_EQ(one.points[i].line_class, three.points[i].line_class);
    }
    EXPECT_EQ(one.counts.rays, three.counts.rays);
}

TEST(SampledLines, FindsNothingInAnEmptyScene) {
    EXPECT_TRUE(sample_lines({}, truth::view_from(6), {}).points.empty());
}

}  // namespace
}  // namespace ink::crosscheck
