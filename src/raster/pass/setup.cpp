#include "raster/pass/setup.h"

#include <algorithm>
#include <cmath>

namespace ink::raster {
namespace {

/// A pixel and its four neighbours fit into no triangle whose least height is below sqrt(2) px: the
/// width of their hull. The rest is margin for rounding.
constexpr double kThin_px = 1.25;

/// Boxes with more centres than this are searched row by row for a sample instead of one by one.
constexpr std::int64_t kFewCentres = 64;

/// The first pixel whose centre is at or beyond a snapped coordinate.
int first_centre(std::int32_t snapped) {
    return (snapped + kSubpixels / 2 - 1) >> kSubpixelBits;
}

PixelRect centres_between(const std::array<ScreenVertex, 3>& corners) {
    const auto [x_min, x_max] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    // Right and lower borders are open, so a centre exactly there is no sample.
    return {first_centre(x_min), first_centre(y_min), first_centre(x_max), first_centre(y_max)};
}

/// The edge from a to b of a triangle with positive area2: clockwise as seen, y running down.
EdgeFunction edge_function(const ScreenVertex& a, const ScreenVertex& b) {
    const std::int64_t dx = static_cast<std::int64_t>(b.x) - a.x;
    const std::int64_t dy = static_cast<std::int64_t>(b.y) - a.y;
    const bool is_top_left = dy < 0 || (dy == 0 && dx > 0);
    constexpr std::int64_t kCentre = kSubpixels / 2;
    EdgeFunction e;
    e.dx = -dy * kSubpixels;
    e.dy = dx * kSubpixels;
    e.at_origin = dx * (kCentre - a.y) - dy * (kCentre - a.x) - (is_top_left ? 0 : 1);
    return e;
}

/// Whether row y holds a centre inside all three edges.
bool row_has_sample(const SetupTriangle& t, int y) {
    std::int64_t first = t.bounds.x0;
    std::int64_t last = t.bounds.x1 - 1;
    for (const EdgeFunction& e : t.edges) {
        const std::int64_t at_zero = e.at(0, y);
        if (e.dx > 0) first = std::max(first, -floor_div(at_zero, e.dx));
        if (e.dx < 0) last = std::min(last, floor_div(at_zero, -e.dx));
        if (e.dx == 0 && at_zero < 0) return false;
    }
    return first <= last;
}

bool has_sample(const SetupTriangle& t) {
    const PixelRect& b = t.bounds;
    const bool is_small = static_cast<std::int64_t>(b.x1 - b.x0) * (b.y1 - b.y0) <= kFewCentres;
    for (int y = b.y0; y < b.y1; ++y) {
        if (!is_small) {
            if (row_has_sample(t, y)) return true;
            continue;
        }
        for (int x = b.x0; x < b.x1; ++x) {
            if (t.covers(x, y)) return true;
        }
    }
    return false;
}

/// Whether the least height of the snapped triangle is below kThin_px.
bool is_thin(const std::array<ScreenVertex, 3>& v, std::int64_t area) {
    double longest2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double dx = static_cast<double>(v[(i + 1) % 3].x) - v[i].x;
        const double dy = static_cast<double>(v[(i + 1) % 3].y) - v[i].y;
        longest2 = std::max(longest2, dx * dx + dy * dy);
    }
    const double height_limit = kThin_px * kSubpixels;
    const double a = static_cast<double>(area);
    return a * a < height_limit * height_limit * longest2;
}

}  // namespace

std::int64_t area2(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    const std::int64_t bx = static_cast<std::int64_t>(b.x) - a.x;
    const std::int64_t by = static_cast<std::int64_t>(b.y) - a.y;
    const std::int64_t cx = static_cast<std::int64_t>(c.x) - a.x;
    const std::int64_t cy = static_cast<std::int64_t>(c.y) - a.y;
    return bx * cy - cx * by;
}

SetupResult set_up(const std::array<ScreenVertex, 3>& corners,
                   int width_px,
                   int height_px,
                   SetupTriangle& out) {
    const PixelRect all = centres_between(corners);
    PixelRect& b = out.bounds;
    b = {std::max(all.x0, 0),
         std::max(all.y0, 0),
         std::min(all.x1, width_px),
         std::min(all.y1, height_px)};
    if (b.is_empty()) return all.is_empty() ? SetupResult::no_sample : SetupResult::outside;

    const std::int64_t area = area2(corners[0], corners[1], corners[2]);
    if (area == 0) return SetupResult::no_sample;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenVertex& from = corners[i];
        const ScreenVertex& to = corners[(i + 1) % 3];
        out.edges[i] = area > 0 ? edge_function(from, to) : edge_function(to, from);
    }
    if (!has_sample(out)) return SetupResult::no_sample;

    out.ref_x = b.x0 + (b.x1 - b.x0) / 2;
    out.ref_y = b.y0 + (b.y1 - b.y0) / 2;
    out.is_thin = is_thin(corners, area);
    const auto [q_min, q_max] = std::minmax({corners[0].q, corners[1].q, corners[2].q});
    out.q_min = q_min;
    out.q_max = q_max;
    out.q = PlaneMaker(corners, out).through({corners[0].q, corners[1].q, corners[2].q});
    return SetupResult::drawn;
}

PlaneMaker::PlaneMaker(const std::array<ScreenVertex, 3>& corners, const SetupTriangle& triangle)
    : x1_(corners[1].x_px - corners[0].x_px),
      y1_(corners[1].y_px - corners[0].y_px),
      x2_(corners[2].x_px - corners[0].x_px),
      y2_(corners[2].y_px - corners[0].y_px),
      ref_x_(triangle.ref_x + 0.5 - corners[0].x_px),
      ref_y_(triangle.ref_y + 0.5 - corners[0].y_px) {
    const double area = x1_ * y2_ - x2_ * y1_;
    one_over_area_ = area == 0 ? 0 : 1 / area;
}

Plane PlaneMaker::through(const PerCorner& values) const {
    const double v1 = values[1] - values[0];
    const double v2 = values[2] - values[0];
    Plane plane;
    plane.dx = (v1 * y2_ - v2 * y1_) * one_over_area_;
    plane.dy = (v2 * x1_ - v1 * x2_) * one_over_area_;
    plane.at_ref = values[0] + plane.dx * ref_x_ + plane.dy * ref_y_;
    if (!std::isfinite(plane.at_ref) || !std::isfinite(plane.dx) || !std::isfinite(plane.dy))
        return {values[0], 0, 0};
    return plane;
}

}  // namespace ink::raster
