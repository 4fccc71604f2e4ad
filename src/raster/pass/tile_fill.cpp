#include "raster/pass/tile_fill.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "raster/pass/stores.h"

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

/// The pixels [begin, end) of one row.
struct Span {
    int begin = 0;
    int end = 0;
};

/// The centres of row y in [x0, x1) inside the triangle: convex, so one run.
Span covered_span(const SetupTriangle& t, const Span& row, int y) {
    std::int64_t e0 = t.edges[0].at(row.begin, y);
    std::int64_t e1 = t.edges[1].at(row.begin, y);
    std::int64_t e2 = t.edges[2].at(row.begin, y);
    const std::int64_t dx0 = t.edges[0].dx;
    const std::int64_t dx1 = t.edges[1].dx;
    const std::int64_t dx2 = t.edges[2].dx;
    const auto step = [&] {
        e0 += dx0;
        e1 += dx1;
        e2 += dx2;
    };
    Span span{row.begin, row.begin};
    for (; span.begin < row.end && (e0 | e1 | e2) < 0; ++span.begin)
        step();
    for (span.end = span.begin; span.end < row.end && (e0 | e1 | e2) >= 0; ++span.end)
        step();
    return span;
}

/// Depth-tests the run and writes what passes; returns how many did.
template <class Depth, class Attributes>
std::uint64_t fill_span(const SetupTriangle& t,
                        const Span& span,
                        double q_row,
                        const Depth& depth,
                        typename Depth::Value* depth_row,
                        const Attributes& attributes) {
    std::uint64_t kept = 0;
    const Plane plane = t.q;
    const double q_min = t.q_min;
    const double q_max = t.q_max;
    const int ref_x = t.ref_x;
    for (int x = span.begin; x < span.end; ++x) {
        const double q = std::clamp(q_row + plane.dx * (x - ref_x), q_min, q_max);
        const typename Depth::Value d = depth.of(q);
        if (!(d > depth_row[x])) continue;
        depth_row[x] = d;
        attributes.write(x, q);
        ++kept;
    }
    return kept;
}

template <class Depth, class Attributes>
void fill_triangle(const FillSource& from,
                   const Depth& depth,
                   TileBuffer& buffer,
                   FillCounts& counts) {
    const SetupTriangle& t = from.triangle();
    const PixelRect& area = buffer.drawn();
    const Span row{std::max(t.bounds.x0, area.x0), std::min(t.bounds.x1, area.x1)};
    const int y_end = std::min(t.bounds.y1, area.y1);
    Attributes attributes(from);
    for (int y = std::max(t.bounds.y0, area.y0); y < y_end; ++y) {
        const Span span = covered_span(t, row, y);
        if (span.begin >= span.end) continue;
        counts.covered += static_cast<std::uint64_t>(span.end - span.begin);
        attributes.start_row(buffer, y);
        const double q_row = t.q.at_ref + t.q.dy * (y - t.ref_y);
        auto* depth_row = buffer.depth_row<typename Depth::Value>(y);
        counts.kept += fill_span(t, span, q_row, depth, depth_row, attributes);
    }
}

template <class Depth, class Attributes>
FillCounts fill_tile(const FillJob& job, std::span<const BinEntry> entries, TileBuffer& buffer) {
    const Depth depth(QuantisedDepth(job.format.depth, job.input.near, job.input.far));
    FillCounts counts;
    for (const BinEntry& entry : entries) {
        const FillSource from{job.format, job.input, job.batches[entry.batch], entry.index};
        fill_triangle<Depth, Attributes>(from, depth, buffer, counts);
    }
    return counts;
}

template <class Attributes>
FillTile with_depth(DepthFormat format) {
    return format == DepthFormat::q32 ? &fill_tile<FloatDepth, Attributes>
                                      : &fill_tile<StepDepth, Attributes>;
}

template <class T, std::size_t kCount, Overflow kOverflow>
FillTile code_fill(const PassFormat& format) {
    return format.interpolation == Interpolation::affine
               ? with_depth<CodeStore<T, kCount, kOverflow>>(format.depth)
               : with_depth<PerspectiveStore<T, kCount, kOverflow>>(format.depth);
}

template <class T, std::size_t kCount>
FillTile code_fill(const PassFormat& format) {
    return format.overflow == Overflow::saturate ? code_fill<T, kCount, Overflow::saturate>(format)
                                                 : code_fill<T, kCount, Overflow::wrap>(format);
}

FillTile float_fill(const PassFormat& format) {
    return format.interpolation == Interpolation::affine
               ? with_depth<FloatStore<4>>(format.depth)
               : with_depth<PerspectiveStore<float, 4, Overflow::saturate>>(format.depth);
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

FillTile fill_function(const PassFormat& format) {
    const int k = format.interpolants;
    const Store store = format.store;
    if (k == 0 && store == Store::none) return with_depth<NoStore>(format.depth);
    if (k == 0 && store == Store::u8) return with_depth<ConstantStore<std::uint8_t>>(format.depth);
    if (k == 0 && store == Store::u32)
        return with_depth<ConstantStore<std::uint32_t>>(format.depth);
    if (k == 1 && store == Store::u8) return code_fill<std::uint8_t, 1>(format);
    if (k == 1 && store == Store::u16) return code_fill<std::uint16_t, 1>(format);
    if (k == 2 && store == Store::u8) return code_fill<std::uint8_t, 2>(format);
    if (k == 4 && store == Store::f32) return float_fill(format);
    assert(false && "no method uses this pair of interpolants and store: add it to fill_function");
    return nullptr;
}

}  // namespace ink::raster
