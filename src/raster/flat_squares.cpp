#include "raster/flat_squares.h"

#include <algorithm>
#include <array>
#include <bit>

namespace ink::raster {
namespace {

// Found by the times of spheres of 20 to 10 000 triangles at 2 to 33 million pixels.
constexpr std::size_t kMostForSquares = 2;
constexpr int kFewSquares = 8;

struct FloatRange {
    float least;
    float greatest;
};

/// What the depth test sees of a triangle in a rectangle.
FloatRange depth_in(const SetupTriangle& t, const PixelRect& rect) {
    const auto at = [&](int x, int y) {
        const double q_row = t.q.at_ref + t.q.dy * (y - t.ref_y);
        return static_cast<float>(std::clamp(q_row + t.q.dx * (x - t.ref_x), t.q_min, t.q_max));
    };
    const std::array<float, 4> corners = {at(rect.x0, rect.y0),
                                          at(rect.x1 - 1, rect.y0),
                                          at(rect.x0, rect.y1 - 1),
                                          at(rect.x1 - 1, rect.y1 - 1)};
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    return {*least, *greatest};
}

bool covers(const SetupTriangle& t, const PixelRect& rect) {
    for (const EdgeFunction& e : t.edges) {
        const int x = e.dx > 0 ? rect.x0 : rect.x1 - 1;
        const int y = e.dy > 0 ? rect.y0 : rect.y1 - 1;
        if (e.at(x, y) < 0) return false;
    }
    return true;
}

bool touches(const SetupTriangle& t, const PixelRect& rect) {
    return t.bounds.x0 < rect.x1 && rect.x0 < t.bounds.x1 && t.bounds.y0 < rect.y1 &&
           rect.y0 < t.bounds.y1 && !misses(t, rect);
}

PixelRect square_of(const PixelRect& own, int square) {
    const int x0 = own.x0 + square % kFlatSquares * kFlatSquare_px;
    const int y0 = own.y0 + square / kFlatSquares * kFlatSquare_px;
    return {x0, y0, std::min(x0 + kFlatSquare_px, own.x1), std::min(y0 + kFlatSquare_px, own.y1)};
}

PixelRect with_halo(const PixelRect& rect, int halo_px) {
    return {rect.x0 - halo_px, rect.y0 - halo_px, rect.x1 + halo_px, rect.y1 + halo_px};
}

bool holds(const PixelRect& outer, const PixelRect& inner) {
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
           inner.y1 <= outer.y1;
}

}  // namespace

/// A code that saturates anywhere in the rectangle is no floor of an affine function there.
bool FlatProof::is_unlimited(const Listed& listed, const PixelRect& rect) const {
    const SetupTriangle& t = listed.triangle();
    if (t.is_thin) return false;
    if (format_.overflow == Overflow::wrap) return true;
    const std::int64_t most = format_.store == Store::u8 ? 0xff : 0xffff;
    const auto planes = static_cast<std::size_t>(format_.interpolants);
    for (std::size_t k = 0; k < planes; ++k) {
        const CodePlane& plane = listed.batch->code_planes[listed.index * planes + k];
        for (const int x : {rect.x0, rect.x1 - 1}) {
            for (const int y : {rect.y0, rect.y1 - 1}) {
                const std::int64_t code =
                    (plane.at_ref + plane.dy * (y - t.ref_y) + plane.dx * (x - t.ref_x)) >>
                    kCodeFractionBits;
                if (code < 0 || code > most) return false;
            }
        }
    }
    return true;
}

bool FlatProof::is_flat(const PixelRect& rect) const {
    const auto owner = std::find_if(triangles_.begin(), triangles_.end(), [&](const Listed& l) {
        return holds(l.triangle().bounds, rect) && covers(l.triangle(), rect) &&
               std::all_of(triangles_.begin(), triangles_.end(), [&](const Listed& other) {
                   return (other.batch == l.batch && other.index == l.index) ||
                          !touches(other.triangle(), rect) ||
                          depth_in(other.triangle(), rect).greatest <
                              depth_in(l.triangle(), rect).least;
               });
    });
    return owner != triangles_.end() && is_unlimited(*owner, rect);
}

std::uint16_t FlatProof::flat_squares(const TileBuffer& tile, int halo_px) const {
    if (triangles_.size() > kMostForSquares) return 0;
    const int least_px = kFlatSquare_px + 2 * halo_px;
    const bool some_may_be =
        std::any_of(triangles_.begin(), triangles_.end(), [&](const Listed& listed) {
            const PixelRect& b = listed.triangle().bounds;
            return b.x1 - b.x0 >= least_px && b.y1 - b.y0 >= least_px;
        });
    if (!some_may_be) return 0;
    std::uint16_t flat = 0;
    for (int square = 0; square < kFlatSquares * kFlatSquares; ++square) {
        const PixelRect rect = square_of(tile.own(), square);
        if (rect.is_empty()) continue;
        const PixelRect wide = with_halo(rect, halo_px);
        if (holds(tile.drawn(), wide) && is_flat(wide))
            flat = static_cast<std::uint16_t>(flat | (1U << square));
    }
    return std::popcount(flat) <= kFewSquares ? std::uint16_t{0} : flat;
}

std::vector<PixelRect> needed_rects(const TileBuffer& tile, std::uint16_t flat, int halo_px) {
    std::vector<PixelRect> rects;
    if (flat == 0) return {tile.drawn()};
    const PixelRect& drawn = tile.drawn();
    for (int square = 0; square < kFlatSquares * kFlatSquares; ++square) {
        const PixelRect own = square_of(tile.own(), square);
        if (own.is_empty() || (flat >> square & 1U) != 0) continue;
        const PixelRect wide = with_halo(own, halo_px);
        const PixelRect rect{std::max(wide.x0, drawn.x0),
                             std::max(wide.y0, drawn.y0),
                             std::min(wide.x1, drawn.x1),
                             std::min(wide.y1, drawn.y1)};
        const bool goes_on =
            square % kFlatSquares > 0 && (flat >> (square - 1) & 1U) == 0 && !rects.empty();
        if (goes_on) {
            rects.back().x1 = rect.x1;
        } else {
            rects.push_back(rect);
        }
    }
    return rects;
}

}  // namespace ink::raster
