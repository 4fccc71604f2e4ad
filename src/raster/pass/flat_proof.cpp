#include "raster/pass/flat_proof.h"

#include <algorithm>
#include <array>

namespace ink::raster {
namespace {

// More triangles than this are seldom flat together, and a proof that spares less than a quarter of
// a tile costs about what it spares.
constexpr std::size_t kMostForStencils = 3;
constexpr int kFewStencils = kTileSize_px * kTileSize_px / 4;

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

bool holds(const PixelRect& outer, const PixelRect& inner) {
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
           inner.y1 <= outer.y1;
}

}  // namespace

/// Depths of whole steps may be equal where these are not.
bool FlatProof::is_behind(const Listed& far, const Listed& near, const PixelRect& rect) const {
    return format_.depth == DepthFormat::q32 &&
           depth_in(far.triangle(), rect).greatest < depth_in(near.triangle(), rect).least;
}

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
                          !touches(other.triangle(), rect) || is_behind(other, l, rect);
               });
    });
    return owner != triangles_.end() && is_unlimited(*owner, rect);
}

bool FlatProof::find_needed(const TileBuffer& tile, int halo_px, NeededRows& needed) {
    if (triangles_.size() > kMostForStencils) return false;
    const PixelRect& own = tile.own();
    const PixelRect& drawn = tile.drawn();
    const int height = own.y1 - own.y0;
    met_.clear();
    for (const Listed& listed : triangles_)
        met_.emplace_back(listed.triangle(), tile, halo_px);
    int spared = 0;
    for (std::size_t i = 0; i < kStencilColumns; ++i) {
        RowRun& run = needed.of[i];
        run = {0, height};
        const int x0 = own.x0 + static_cast<int>(i) * kStencilColumn_px;
        if (x0 >= own.x1) run.end = 0;
        const PixelRect column{x0 - halo_px, drawn.y0, x0 + kStencilColumn_px + halo_px, drawn.y1};
        if (x0 + kStencilColumn_px > own.x1 || !holds(drawn, column)) continue;
        const RowRun proven = lone_rows(column, i);
        const int to_own = drawn.y0 - own.y0;
        if (drawn.y0 < own.y0) run.begin = std::max(proven.begin + to_own - halo_px, 0);
        if (drawn.y1 > own.y1) run.end = std::min(proven.end + to_own + halo_px, height);
        spared += kStencilColumn_px * (height - run.count());
    }
    return spared >= kFewStencils;
}

/// How far down from a column's first row, and how far up from its last, no more than one triangle
/// is met, in rows from the first.
RowRun FlatProof::lone_rows(const PixelRect& column, std::size_t at) const {
    const int rows = column.y1 - column.y0;
    RowRun sky{rows, 0};
    for (const TriangleRows& met : met_) {
        const RowRun touched = met.touched(at);
        if (touched.is_empty()) continue;
        sky.begin = std::min(sky.begin, touched.begin);
        sky.end = std::max(sky.end, touched.end);
    }
    RowRun best = sky;
    for (std::size_t owner = 0; owner < triangles_.size(); ++owner) {
        const RowRun inside = met_[owner].inside(at);
        RowRun lone{inside.begin <= 0 ? inside.end : 0, inside.end >= rows ? inside.begin : rows};
        if (lone.begin <= best.begin && lone.end >= best.end) continue;
        for (std::size_t other = 0; other < triangles_.size(); ++other) {
            if (other == owner) continue;
            const RowRun touched = met_[other].touched(at);
            if (touched.is_empty() || is_behind(triangles_[other], triangles_[owner], column))
                continue;
            lone.begin = std::min(lone.begin, touched.begin);
            lone.end = std::max(lone.end, touched.end);
        }
        const auto is_proven = [&](int begin, int end) {
            return is_unlimited(triangles_[owner],
                                {column.x0, column.y0 + begin, column.x1, column.y0 + end});
        };
        if (lone.begin > best.begin && is_proven(0, lone.begin)) best.begin = lone.begin;
        if (lone.end < best.end && is_proven(lone.end, rows)) best.end = lone.end;
    }
    return best;
}

}  // namespace ink::raster
