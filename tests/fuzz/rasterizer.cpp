// Triangles near every limit cover the pixel centres that exact arithmetic says, once along a
// shared edge, and the nearest is kept.

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "raster/pass/clip.h"
#include "raster/pass/screen_vertex.h"
#include "tests/fuzz/exact_coverage.h"
#include "tests/fuzz/fuzz.h"
#include "tests/raster/gather_sink.h"

namespace ink::fuzz {
namespace {

using raster::kNobody;
using Clip = glm::dvec3;  // (x, y, w)
using Mask = core::Image<int>;

constexpr int kMostPoints = 6;
constexpr int kMostTriangles = 5;

/// What is drawn.
struct Drawing {
    raster::TestMesh mesh;
    double near = 0.5;
    int width_px = 1;
    int height_px = 1;
};

// ---- Input ------------------------------------------------------------------------------------

double nudged(double value, int ulps) {
    for (int i = 0; i < std::abs(ulps); ++i)
        value = std::nextafter(value, ulps > 0 ? 1e300 : -1e300);
    return value;
}

/// A coordinate on the screen: on grids, near borders of the image, of the reach of lanes and of
/// the guard band, and far away.
double screen_px(Feed& feed) {
    const int side = feed.flag() ? 1 : -1;
    switch (feed.whole(0, 7)) {
        case 0:
            return feed.whole(-20, 180) / 2.0;
        case 1:
            return feed.whole(-5120, 25600) / 256.0;
        case 2:
            return feed.whole(-5120, 25600) / 512.0;  // half way between two places of the grid
        case 3:
            return side * nudged(raster::kLaneReach_px, feed.whole(-2, 2));
        case 4:
            return side * nudged(raster::kGuardBand_px, feed.whole(-2, 2));
        case 5:
            return feed.real(-3000, 3000);
        case 6:
            return feed.real(-4e6, 4e6);
        default:
            return feed.real(-20, 100);
    }
}

double distance(double near, Feed& feed) {
    switch (feed.whole(0, 6)) {
        case 0:
            // So far away that a cut edge has no digits left: then no place is exact, but all are
            // finite.
            return feed.flag() ? 1 : feed.real(near, 1e20);
        case 1:
            return nudged(near, feed.whole(-2, 2));
        case 2:
            return feed.real(-near, near);
        case 3:
            return -feed.real(0, 100);
        case 4:
            return feed.real(near, 1e6);
        default:
            return feed.real(near, 8 * near);
    }
}

/// `before` is the last point, if there is one.
Clip point(double near, const Clip* before, Feed& feed) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (feed.whole(0, 255) == 255) {  // rarely what is no number, or too large for one
        constexpr std::array kOdd{
            std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e151, -1e300};
        Clip odd{1, 1, 1};
        odd[feed.whole(0, 2)] = kOdd[static_cast<std::size_t>(feed.whole(0, 4))];
        return odd;
    }
    const double w = distance(near, feed);
    // Every other point stands above or beside the one before: edges are level and upright.
    const int shared = before == nullptr || before->z == 0 ? 3 : feed.whole(0, 3);
    const double x_px = shared == 0 ? before->x / before->z : screen_px(feed);
    const double y_px = shared == 1 ? before->y / before->z : screen_px(feed);
    return {x_px * w, y_px * w, w};
}

Drawing drawing(Feed& feed) {
    Drawing made;
    made.width_px = feed.whole(1, 80);  // more than a tile
    made.height_px = feed.whole(1, 40);
    constexpr std::array kNears{0.5, 1e-3, 1.0 / 3, 1.0};
    made.near = kNears[static_cast<std::size_t>(feed.whole(0, 3))];
    const int points = feed.whole(3, kMostPoints);
    std::vector<Clip>& all = made.mesh.p_clip;
    for (int i = 0; i < points; ++i)
        all.push_back(point(made.near, all.empty() ? nullptr : &all.back(), feed));
    const int triangles = feed.whole(1, kMostTriangles);
    for (int i = 0; i < triangles; ++i) {
        scene::Triangle triangle{};
        for (std::uint32_t& corner : triangle)
            corner = static_cast<std::uint32_t>(feed.whole(0, points - 1));
        made.mesh.triangles.push_back(triangle);
    }
    return made;
}

raster::PassInput input_of(const Drawing& made) {
    raster::PassInput input = made.mesh.input();
    input.near = made.near;
    return input;
}

ClipCorners corners(const Drawing& made, std::size_t triangle) {
    const auto& [a, b, c] = made.mesh.triangles[triangle];
    return {made.mesh.p_clip[a], made.mesh.p_clip[b], made.mesh.p_clip[c]};
}

// ---- Coverage -----------------------------------------------------------------------------------

void check_uncut(const ClipCorners& corners, const Mask& covered) {
    for (int y = 0; y < covered.height_px(); ++y) {
        for (int x = 0; x < covered.width_px(); ++x)
            expect((covered.at(x, y) != 0) == covers_exactly(corners, x, y),
                   "an uncut triangle covers the centres that whole numbers say");
    }
}

void check_cut(const Outline& seen, const Mask& covered) {
    for (int y = 0; y < covered.height_px(); ++y) {
        for (int x = 0; x < covered.width_px(); ++x) {
            if (seen.has_inside(x, y))
                expect(covered.at(x, y) != 0, "what is inside a cut triangle is covered");
            if (seen.has_outside(x, y))
                expect(covered.at(x, y) == 0, "what is outside a cut triangle is not covered");
        }
    }
}

// ---- Laws ---------------------------------------------------------------------------------------

void check_clip(const ClipCorners& p, double near) {
    std::array<raster::ClipVertex, 3> triangle;
    double largest = near;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle[i].p_clip = p[i];
        largest = std::max({largest, std::abs(p[i].x), std::abs(p[i].y), std::abs(p[i].z)});
    }
    const raster::ClipPolygon polygon = raster::clip_triangle(triangle, near);
    expect(polygon.count == 0 || (polygon.count >= 3 && polygon.count <= 8),
           "a clipped triangle has 3 to 8 corners, or none");
    for (int i = 0; i < polygon.count; ++i) {
        const Clip& corner = polygon.corners[static_cast<std::size_t>(i)].p_clip;
        expect(corner.z >= near, "no corner is before near");
        for (int plane = 1; plane < raster::kClipPlanes; ++plane)
            expect(raster::inside_by(plane, corner, near, raster::kGuardBand_px) >=
                       -1e-14 * raster::kGuardBand_px * largest,
                   "no corner is beyond the guard band by more than rounding");
    }
}

/// One triangle by itself.
struct Alone {
    Mask covered;
    core::Image<float> depth;
    std::optional<Outline> seen;
};

Alone draw_alone(const Drawing& made, std::size_t triangle) {
    raster::PassInput input = input_of(made);
    input.triangles = input.triangles.subspan(triangle, 1);
    auto sink = raster::draw_ids(input, made.width_px, made.height_px);
    Alone alone{Mask(made.width_px, made.height_px), std::move(sink.depth), std::nullopt};
    for (std::size_t i = 0; i < alone.covered.size(); ++i) {
        const bool is_covered = sink.planes[0].data()[i] != kNobody;
        alone.covered.data()[i] = is_covered ? 1 : 0;
        const float q = alone.depth.data()[i];
        expect(std::isfinite(q) && (q > 0) == is_covered, "covered pixels have a depth");
        expect(q <= static_cast<float>(1 / made.near) * 1.00001F, "nothing is before near");
    }
    return alone;
}

void check_alone(const Drawing& made, std::size_t triangle, Alone& alone) {
    const ClipCorners p = corners(made, triangle);
    unsigned outside = 0;
    for (const Clip& corner : p)
        outside |= raster::outcode(corner, made.near);
    if ((outside & raster::kNotANumber) != 0) {
        expect(alone.covered == Mask(made.width_px, made.height_px),
               "what is not a number is not drawn");
        return;
    }
    check_clip(p, made.near);
    if (outside == raster::kInside) check_uncut(p, alone.covered);
    alone.seen = outline_of(p, made.near);
    if (alone.seen) check_cut(*alone.seen, alone.covered);
}

/// What lies inside of all lines but edge `i` of `a`, and all but edge `j` of `b`, which is the
/// same with the triangles on different sides of it.
void check_shared(const Alone& a, std::size_t i, const Alone& b, std::size_t j) {
    for (int y = 0; y < a.covered.height_px(); ++y) {
        for (int x = 0; x < a.covered.width_px(); ++x) {
            if (!a.seen->has_inside(x, y, i) || !b.seen->has_inside(x, y, j)) continue;
            expect((a.covered.at(x, y) != 0) != (b.covered.at(x, y) != 0),
                   "a centre near a shared edge is covered once");
        }
    }
}

void check_neighbours(const Drawing& made, const std::vector<Alone>& alone) {
    const auto& triangles = made.mesh.triangles;
    const auto check_pair = [&](std::size_t a, std::size_t b) {
        for (std::size_t edges = 0; edges < 9; ++edges) {
            const std::size_t i = edges / 3;
            const std::size_t j = edges % 3;
            const bool is_shared = triangles[a][i] == triangles[b][(j + 1) % 3] &&
                                   triangles[a][(i + 1) % 3] == triangles[b][j];
            if (is_shared && alone[a].seen->turn == alone[b].seen->turn)
                check_shared(alone[a], i, alone[b], j);
        }
    };
    for (std::size_t a = 0; a < triangles.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (alone[a].seen && alone[b].seen) check_pair(a, b);
        }
    }
}

void check_together(const Drawing& made, const std::vector<Alone>& alone) {
    const auto all = raster::draw_ids(input_of(made), made.width_px, made.height_px);
    for (std::size_t i = 0; i < all.depth.size(); ++i) {
        std::uint32_t nearest = kNobody;
        float q = 0;
        for (std::size_t t = 0; t < alone.size(); ++t) {
            if (alone[t].covered.data()[i] == 0 || alone[t].depth.data()[i] <= q) continue;
            nearest = static_cast<std::uint32_t>(t);
            q = alone[t].depth.data()[i];
        }
        expect(all.planes[0].data()[i] == nearest, "the nearest is kept, the first of equal ones");
        expect(all.depth.data()[i] == q, "and its depth");
    }
}

}  // namespace

void check_rasterizer(Bytes bytes) {
    Feed feed(bytes);
    const Drawing made = drawing(feed);
    std::vector<Alone> alone;
    for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
        alone.push_back(draw_alone(made, t));
        check_alone(made, t, alone.back());
    }
    check_neighbours(made, alone);
    check_together(made, alone);
}

}  // namespace ink::fuzz
