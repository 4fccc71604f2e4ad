#include "tests/fuzz/exact_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "raster/pass/screen_vertex.h"

namespace ink::fuzz {
namespace {

using Long = long double;

/// A coordinate in 1/256 px, by the rules of raster/pass/screen_vertex.h.
std::int64_t snapped(double px) {
    if (std::abs(px) > raster::kLaneReach_px) return std::llrint(px * 256);
    return static_cast<std::int64_t>(std::floor((std::nearbyint(px * 65536) + 128) / 256));
}

struct Place {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

__extension__ typedef __int128 Wide;

/// Twice the area.
Wide area(const Place& a, const Place& b, const Place& c) {
    return Wide(b.x - a.x) * (c.y - a.y) - Wide(c.x - a.x) * (b.y - a.y);
}

/// Many times what a long double rounds by.
constexpr Long kRounding = 1e-18L;
constexpr Long kMostPixelsAcross = 1e4L;

/// The volume that a ray spans with two corners.
Outline::Line volume(const glm::dvec3& a, const glm::dvec3& b) {
    const Long ax = a.x, ay = a.y, aw = a.z, bx = b.x, by = b.y, bw = b.z;
    const Long largest =
        std::abs(ay * bw) + std::abs(aw * by) + std::abs(aw * bx) + std::abs(ax * bw);
    return {ay * bw - aw * by,
            aw * bx - ax * bw,
            ax * by - ay * bx,
            kRounding * (kMostPixelsAcross * largest + std::abs(ax * by) + std::abs(ay * bx))};
}

/// How far a corner on the screen may be from its place: it is put on a grid of 1/256 px, and where
/// near or the guard band cut an edge, its numbers are rounded in the size of the edge's ends.
double margin_px(const ClipCorners& corners, double near) {
    double largest = 0;
    for (const glm::dvec3& p : corners)
        largest = std::max(
            {largest, std::abs(p.x), std::abs(p.y), raster::kGuardBand_px * std::abs(p.z)});
    return 1.0 / 256 + 1e-15 * largest / near;
}

}  // namespace

bool covers_exactly(const ClipCorners& corners, int x, int y) {
    std::array<Place, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const double q = 1 / corners[i].z;
        p[i] = {snapped(corners[i].x * q), snapped(corners[i].y * q)};
    }
    if (area(p[0], p[1], p[2]) == 0) return false;
    if (area(p[0], p[1], p[2]) < 0) std::swap(p[1], p[2]);
    const Place centre{256 * std::int64_t{x} + 128, 256 * std::int64_t{y} + 128};
    for (std::size_t i = 0; i < 3; ++i) {
        const Place& a = p[i];
        const Place& b = p[(i + 1) % 3];
        const Wide side = area(a, b, centre);
        const bool is_top = a.y == b.y && b.x > a.x;
        const bool is_left = b.y < a.y;
        if (side < 0 || (side == 0 && !is_top && !is_left)) return false;
    }
    return true;
}

Side Outline::side(std::size_t line, int x, int y) const {
    const Line& l = lines[line];
    const Long middle = l.x * (x + 0.5L) + l.y * (y + 0.5L) + l.c;
    const Long reach = margin_px * (std::abs(l.x) + std::abs(l.y)) + l.slack;
    if (middle > reach) return Side::inside;
    return middle < -reach ? Side::outside : Side::unknown;
}

bool Outline::has_inside(int x, int y, std::size_t but) const {
    for (std::size_t line = 0; line < kLines; ++line) {
        if (line != but && side(line, x, y) != Side::inside) return false;
    }
    return true;
}

bool Outline::has_outside(int x, int y) const {
    for (std::size_t line = 0; line < kLines; ++line) {
        if (side(line, x, y) == Side::outside) return true;
    }
    return false;
}

std::optional<Outline> outline_of(const ClipCorners& corners, double near) {
    Outline made;
    for (std::size_t i = 0; i < 3; ++i)
        made.lines[i] = volume(corners[i], corners[(i + 1) % 3]);
    const Outline::Line& first = made.lines[0];
    const glm::dvec3& p = corners[2];
    const Long all = first.x * p.x + first.y * p.y + first.c * p.z;
    const Long doubt =
        kRounding * (std::abs(first.x * p.x) + std::abs(first.y * p.y) + std::abs(first.c * p.z)) +
        first.slack * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
    if (!(std::abs(all) > 4 * doubt)) return std::nullopt;
    made.turn = all > 0 ? 1 : -1;
    // The three volumes' sum is that of the corners over the distance at which the ray meets them.
    Outline::Line& cut = made.lines[3];
    cut = {0, 0, std::abs(all), doubt};
    for (std::size_t i = 0; i < 3; ++i) {
        Outline::Line& l = made.lines[i];
        l = {made.turn * l.x, made.turn * l.y, made.turn * l.c, l.slack};
        cut = {cut.x - near * l.x, cut.y - near * l.y, cut.c - near * l.c, cut.slack + l.slack};
    }
    made.margin_px = ::ink::fuzz::margin_px(corners, near);
    return made;
}

}  // namespace ink::fuzz
