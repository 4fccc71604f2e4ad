#include "raster/pass/flat_proof.h"

#include <algorithm>
#include <array>

namespace ink::raster {
namespace {

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

}  // namespace ink::raster
