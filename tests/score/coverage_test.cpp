#include "score/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/score/curves.h"

namespace {

using ink::score::draw_coverage;
using Coverage = ink::core::Image<float>;

double total(const Coverage& coverage) {
    double sum = 0;
    for (std::size_t i = 0; i < coverage.size(); ++i)
        sum += coverage.data()[i];
    return sum;
}

/// The area of the unit square where nx x + ny y <= d: a triangle, less those beyond its corners.
double half_plane(double nx, double ny, double d) {
    // Mirrored so that both are positive; a square has its mirror images' areas.
    if (nx < 0) d -= nx;
    if (ny < 0) d -= ny;
    nx = std::abs(nx);
    ny = std::abs(ny);
    if (std::min(nx, ny) < 1e-9) return std::clamp(d / std::max(nx, ny), 0.0, 1.0);
    const auto square = [](double t) { return t > 0 ? t * t : 0; };
    return (square(d) - square(d - nx) - square(d - ny) + square(d - nx - ny)) / (2 * nx * ny);
}

/// The share of pixel (x, y) within `half` of the line through (px, py) with the unit normal n.
double band(int x, int y, double px, double py, double nx, double ny, double half) {
    const double d = nx * (px - x) + ny * (py - y);
    return half_plane(nx, ny, d + half) - half_plane(nx, ny, d - half);
}

/// The area of the pixel from (x, y) within a disc round the origin, by exact columns, a hundred
/// times finer than what is asked of it.
double disc_in_pixel(double x, double y, double radius) {
    constexpr int kColumns = 4000;
    double sum = 0;
    for (int i = 0; i < kColumns; ++i) {
        const double u = x + (i + 0.5) / kColumns;
        if (std::abs(u) >= radius) continue;
        const double half = std::sqrt(radius * radius - u * u);
        sum += std::max(0.0, std::min(half, y + 1) - std::max(-half, y));
    }
    return sum / kColumns;
}

TEST(Coverage, OfAStraightLineIsThatOfItsBandAtAnyAngleAndOffset) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    for (int turn = 0; turn < 400; ++turn) {
        // Every fourth is upright, level or diagonal but for little.
        const double angle = turn % 4 == 0 ? std::numbers::pi / 4 * turn + 1e-3 * share(random)
                                           : 2 * std::numbers::pi * share(random);
        const double width = 0.5 + 3.5 * share(random);
        const double px = 6 + share(random);
        const double py = 6 + share(random);
        const double dx = std::cos(angle), dy = std::sin(angle);
        const Coverage coverage = draw_coverage(
            {{curve(px - 40 * dx, py - 40 * dy, px + 40 * dx, py + 40 * dy)}}, 13, 13, width);
        for (int y = 0; y < 13; ++y) {
            for (int x = 0; x < 13; ++x) {
                ASSERT_NEAR(coverage.at(x, y), band(x, y, px, py, -dy, dx, width / 2), 1e-3)
                    << "angle " << angle << ", width " << width << ", pixel " << x << " " << y;
            }
        }
    }
}

TEST(Coverage, OfALineInPiecesIsThatOfTheWholeLine) {
    Curves pieces;
    const auto at = [](int i) { return std::pair(2 + 0.7 * i, 3 + 0.3 * i); };
    for (int i = 0; i < 30; ++i)
        pieces.push_back(curve(at(i).first, at(i).second, at(i + 1).first, at(i + 1).second));
    const Coverage whole = draw_coverage(
        {{curve(at(0).first, at(0).second, at(30).first, at(30).second)}}, 28, 16, 1.5);
    const Coverage joined = draw_coverage(pieces, 28, 16, 1.5);
    for (std::size_t i = 0; i < whole.size(); ++i)
        ASSERT_NEAR(joined.data()[i], whole.data()[i], 1e-3) << i;
}

TEST(Coverage, OfAPointIsADisc) {
    for (const double width : {0.5, 1.0, 1.5, 2.0, 3.3, 4.0}) {
        for (const auto& [px, py] : {std::pair(4.5, 4.5), {4.0, 4.0}, {4.31, 4.77}}) {
            const Coverage coverage = draw_coverage({{curve(px, py, px, py)}}, 9, 9, width);
            for (int y = 0; y < 9; ++y) {
                for (int x = 0; x < 9; ++x) {
                    ASSERT_NEAR(coverage.at(x, y), disc_in_pixel(x - px, y - py, width / 2), 1e-3)
                        << width << " at " << px << " " << py << ", pixel " << x << " " << y;
                }
            }
            EXPECT_NEAR(total(coverage), std::numbers::pi * width * width / 4, 2e-3) << width;
        }
    }
}

TEST(Coverage, OfALineHasRoundEnds) {
    const Coverage coverage = draw_coverage({{curve(5.2, 6.1, 14.7, 11.3)}}, 22, 18, 1.5);
    const double length = std::hypot(9.5, 5.2);
    EXPECT_NEAR(total(coverage), 1.5 * length + std::numbers::pi * 0.75 * 0.75, 5e-3);
}

TEST(Coverage, OfUprightCrossingStrokesIsTheirUnion) {
    const double cx = 6.37, cy = 6.82, half = 0.75;
    const Coverage coverage =
        draw_coverage({{curve(cx, -20, cx, 40), curve(-20, cy, 40, cy)}}, 13, 13, 2 * half);
    const auto overlap = [half](double centre, int at) {
        return std::max(0.0, std::min(centre + half, at + 1.0) - std::max(centre - half, 1.0 * at));
    };
    for (int y = 0; y < 13; ++y) {
        for (int x = 0; x < 13; ++x) {
            const double u = overlap(cx, x), v = overlap(cy, y);
            ASSERT_NEAR(coverage.at(x, y), u + v - u * v, 1e-3) << x << " " << y;
        }
    }
}

TEST(Coverage, OfCrossingStrokesCountsTheirRhombusOnce) {
    for (const double degrees : {90.0, 45.0, 20.0}) {
        for (const double width : {0.5, 1.5, 4.0}) {
            const double angle = degrees * std::numbers::pi / 180;
            const auto line = [](double turn) {
                const double dx = 24 * std::cos(turn), dy = 24 * std::sin(turn);
                return curve(30.3 - dx, 30.6 - dy, 30.3 + dx, 30.6 + dy);
            };
            const Coverage a = draw_coverage({{line(0.3)}}, 61, 61, width);
            const Coverage b = draw_coverage({{line(0.3 + angle)}}, 61, 61, width);
            const Coverage both = draw_coverage({{line(0.3), line(0.3 + angle)}}, 61, 61, width);
            EXPECT_NEAR(total(a) + total(b) - total(both), width * width / std::sin(angle), 1e-2)
                << degrees << " degrees, " << width << " px";
        }
    }
}

TEST(Coverage, DoesNotDependOnWhatIsDrawnTwiceOrInWhichOrder) {
    Curves curves = circle(20, 20, 11.3, 57);
    curves.push_back(curve(3, 35, 37, 4));
    Curves twice(curves.rbegin(), curves.rend());
    twice.insert(twice.end(), curves.begin(), curves.end());
    const Coverage once = draw_coverage(curves, 40, 40, 1.5);
    const Coverage again = draw_coverage(twice, 40, 40, 1.5);
    for (std::size_t i = 0; i < once.size(); ++i)
        ASSERT_NEAR(once.data()[i], again.data()[i], 1e-6) << i;
}

TEST(Coverage, OfAThinLineIsItsAreaTo256th) {
    const Coverage coverage = draw_coverage({{curve(-5, 3.2, 30, 9.9)}}, 20, 14, 0.25);
    const double length = std::hypot(35, 6.7);
    for (int y = 0; y < 14; ++y) {
        for (int x = 0; x < 20; ++x) {
            ASSERT_NEAR(coverage.at(x, y),
                        band(x, y, -5, 3.2, -6.7 / length, 35 / length, 0.125),
                        1.0 / 256)
                << x << " " << y;
        }
    }
}

TEST(Coverage, OfNothingIsNothing) {
    EXPECT_EQ(total(draw_coverage({}, 8, 8, 1.5)), 0);
    EXPECT_TRUE(draw_coverage({{curve(0, 0, 5, 5)}}, 0, 0, 1.5).is_empty());
    EXPECT_EQ(total(draw_coverage({{curve(-20, -20, -5, -9)}}, 8, 8, 1.5)), 0);
}

}  // namespace
