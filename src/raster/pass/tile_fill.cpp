#include "raster/pass/tile_fill.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "raster/pass/stores.h"

namespace ink::raster {
namespace {

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

FillTile fill_function(const PassFormat& format) {
    const int k = format.interpolants;
    const Store store = format.store;
    if (k == 0 && store == Store::none) return with_depth<NoStore>(format.depth);
    if (k == 0 && store == Store::u8) return with_depth<ConstantStore<std::uint8_t>>(format.depth);
    if (k == 0 && store == Store::u16)
        return with_depth<ConstantStore<std::uint16_t>>(format.depth);
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
