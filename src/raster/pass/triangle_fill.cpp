#include "raster/pass/tile_fill.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/pass/triangle_fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "raster/pass/narrow_constant.inl"
#include "raster/pass/pixel_lanes.inl"
#include "raster/pass/pixel_values.inl"

/// What of a triangle's box is drawn, and the edges that cross it, in 32 bits from (x0, y0).
struct Area {
    PixelRect rect;
    std::int32_t at[3], dx[3], dy[3];  ///< all 0 of an edge that has every centre inside
};

/// False where some edge has all of the rectangle outside.
bool MakeArea(const SetupTriangle& t, const PixelRect& rect, Area& area) {
    area.rect = rect;
    for (int k = 0; k < 3; ++k) {
        const EdgeFunction& e = t.edges[static_cast<std::size_t>(k)];
        const int x_most = e.dx > 0 ? rect.x1 - 1 : rect.x0;
        const int y_most = e.dy > 0 ? rect.y1 - 1 : rect.y0;
        if (e.at(x_most, y_most) < 0) return false;
        const int x_least = e.dx > 0 ? rect.x0 : rect.x1 - 1;
        const int y_least = e.dy > 0 ? rect.y0 : rect.y1 - 1;
        area.at[k] = area.dx[k] = area.dy[k] = 0;
        if (e.at(x_least, y_least) >= 0) continue;
        // It crosses the area, so the value fits; steps are whole multiples of 256.
        area.at[k] = static_cast<std::int32_t>(e.at(rect.x0, rect.y0) >> kSubpixelBits);
        area.dx[k] = static_cast<std::int32_t>(e.dx >> kSubpixelBits);
        area.dy[k] = static_cast<std::int32_t>(e.dy >> kSubpixelBits);
    }
    return true;
}

/// Rows of a column of vectors, counted from the area's first: outside [begin, end) none of its
/// centres is in the triangle, in [inside_begin, inside_end) all are.
struct ColumnRows {
    int begin = 0;
    int inside_begin = 0;
    int inside_end = 0;
    int end = 0;
};

HWY_INLINE int FloorDiv(int a, int b) {
    const int quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

/// No more than the rows [0, end).
ColumnRows Within(const ColumnRows& r, int end) {
    const auto limited = [&](int row) { return std::min(std::max(row, 0), end); };
    return {limited(r.begin), limited(r.inside_begin), limited(r.inside_end), limited(r.end)};
}

/// Of the area's columns first .. last.
ColumnRows RowsOf(const Area& area, int first, int last) {
    const int rows = area.rect.y1 - area.rect.y0;
    ColumnRows r{0, 0, rows, rows};
    for (int k = 0; k < 3; ++k) {
        const int dx = area.dx[k];
        const int dy = area.dy[k];
        if ((dx | dy) == 0) continue;
        const int most = area.at[k] + dx * (dx > 0 ? last : first);
        const int least = area.at[k] + dx * (dx > 0 ? first : last);
        if (dy > 0) {  // not negative from the row -v / dy on
            r.begin = std::max(r.begin, -FloorDiv(most, dy));
            r.inside_begin = std::max(r.inside_begin, -FloorDiv(least, dy));
        } else if (dy < 0) {  // or up to the row v / -dy
            r.end = std::min(r.end, FloorDiv(most, -dy) + 1);
            r.inside_end = std::min(r.inside_end, FloorDiv(least, -dy) + 1);
        } else {
            if (most < 0) r.end = 0;
            if (least < 0) r.inside_end = 0;
        }
    }
    if (r.inside_begin >= r.inside_end) r.inside_begin = r.inside_end = r.end;
    return r;
}

/// One column of vectors, from its top left pixel.
struct Column {
    std::ptrdiff_t at;  ///< of the area's first row
    MI in_rect;
    VI edge[3];
    Doubles q;  ///< what runs along a row
};

/// Everything here is a local of the one function that it is inlined into: what a row changes stays
/// in registers.
template <bool kTestsEdges, class Depth, class Values>
HWY_INLINE void FillRows(const Area& area,
                         const Column& column,
                         const RowStarts& q_starts,
                         int begin,
                         int end,
                         const Depth& depth,
                         Values& values,
                         typename Depth::Value* plane) {
    if (begin >= end) return;
    const DI d;
    const auto start = [&](int k) {
        return hn::Add(column.edge[k], hn::Set(d, area.dy[k] * begin));
    };
    auto e0 = start(0);
    auto e1 = start(1);
    auto e2 = start(2);
    const auto step0 = hn::Set(d, area.dy[0]);
    const auto step1 = hn::Set(d, area.dy[1]);
    const auto step2 = hn::Set(d, area.dy[2]);
    const auto minus_one = hn::Set(d, -1);
    values.StartRows(begin);
    std::ptrdiff_t at = column.at + std::ptrdiff_t{kTileStride} * begin;
    for (int row = begin; row < end; ++row, at += kTileStride) {
        auto mask = column.in_rect;
        if (kTestsEdges) {
            mask = hn::And(mask, hn::Gt(hn::Or3(e0, e1, e2), minus_one));
            e0 = hn::Add(e0, step0);
            e1 = hn::Add(e1, step1);
            e2 = hn::Add(e2, step2);
        }
        const auto q_row = q_starts.at(row);
        const auto q = column.q.map([&](VD part) { return hn::Add(q_row, part); });
        values.Write(at, row, q, depth.Test(q, mask, plane + at));
    }
}

/// One triangle in one tile, column by column.
template <class Depth, class Values>
void FillArea(const FillJob& job, const OneTriangle& triangle, const Area& area, TileBuffer& to) {
    const DI d;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));
    const SetupTriangle& t = triangle.setup();
    const PixelRect& r = area.rect;
    const Depth depth(t, QuantisedDepth(job.format.depth, job.input.near, job.input.far));
    auto* const plane = to.depth_row<typename Depth::Value>(0);
    RowStarts q_starts;
    q_starts.fill(t.q, triangle.first_row(), triangle.rows);
    typename Values::Tables tables;
    Values values(triangle, tables, to);
    // Vectors start where cache lines do.
    const int origin = to.own().x0 - kTileMargin_px;
    for (int x = r.x0 - (r.x0 - origin) % kLanes; x < r.x1; x += kLanes) {
        const int first = x - r.x0;
        const ColumnRows rows =
            Within(RowsOf(area, std::max(first, 0), std::min(first + kLanes, r.x1 - r.x0) - 1),
                   r.y1 - r.y0);
        if (rows.begin >= rows.end) continue;
        const auto ramp = hn::Load(d, kRamp);
        const auto across = hn::Add(ramp, hn::Set(d, first));
        const auto from_ref = hn::Add(ramp, hn::Set(d, x - t.ref_x));
        const auto from_ref_wide = Widen(DD(), from_ref);
        Column column;
        column.at = static_cast<std::ptrdiff_t>(r.y0) * kTileStride + x;
        column.in_rect =
            hn::And(hn::Gt(across, hn::Set(d, -1)), hn::Lt(across, hn::Set(d, r.x1 - r.x0)));
        for (int k = 0; k < 3; ++k)
            column.edge[k] =
                hn::Add(hn::Set(d, area.at[k]), hn::Mul(hn::Set(d, area.dx[k]), across));
        column.q = Ramp(t.q, from_ref_wide);
        values.StartColumn(from_ref, from_ref_wide);
        const auto fill = [&](auto tests_edges, int begin, int end) HWY_ATTR {
            FillRows<decltype(tests_edges)::value>(
                area, column, q_starts, begin, end, depth, values, plane);
        };
        fill(std::true_type(), rows.begin, rows.inside_begin);
        fill(std::false_type(), rows.inside_begin, rows.inside_end);
        fill(std::true_type(), rows.inside_end, rows.end);
    }
}

template <class Values>
bool FillWith(const FillJob& job, const BinEntry& entry, const Area& area, TileBuffer& to) {
    const Batch& batch = job.batches[entry.batch];
    const std::uint32_t constant =
        job.format.constant ? job.input.constants[batch.triangles[entry.index].triangle] : 0;
    const OneTriangle triangle{
        job.format, batch, entry.index, area.rect.y0, area.rect.y1 - area.rect.y0, constant};
    if (job.format.depth == DepthFormat::q32) {
        FillArea<FloatDepthLanes, Values>(job, triangle, area, to);
    } else {
        FillArea<StepDepthLanes, Values>(job, triangle, area, to);
    }
    return true;
}

/// Whether no centre's code can leave the store: the corners' do not, by a margin for centres of
/// the snapped triangle that lie a little outside the true one.
bool AreInner(const FillJob& job, const BinEntry& entry) {
    const Batch& batch = job.batches[entry.batch];
    if (batch.triangles[entry.index].is_thin) return false;
    if (job.format.overflow == Overflow::wrap) return true;
    const auto count = static_cast<std::size_t>(job.format.interpolants);
    const std::int64_t most = (job.format.store == Store::u8 ? std::int64_t{0xff} : 0xffff)
                              << kCodeFractionBits;
    for (std::size_t k = 0; k < count; ++k) {
        const CodePlane& p = batch.code_planes[entry.index * count + k];
        const std::int64_t margin =
            (p.highest - p.lowest) / 64 + (std::int64_t{2} << kCodeFractionBits);
        if (p.lowest < margin || p.highest > most - margin) return false;
    }
    return true;
}

template <int kCount>
bool FillCodes(const FillJob& job, const BinEntry& entry, const Area& area, TileBuffer& to) {
    if (job.format.interpolation == Interpolation::perspective)
        return FillWith<PerspectiveCodeValues<kCount>>(job, entry, area, to);
    return AreInner(job, entry) ? FillWith<CodeValues<kCount>>(job, entry, area, to)
                                : FillWith<LimitedCodeValues<kCount>>(job, entry, area, to);
}

bool FillConstant(const FillJob& job, const BinEntry& entry, const Area& area, TileBuffer& to) {
    return job.format.store == Store::u8
               ? FillWith<ConstantValues<std::uint8_t>>(job, entry, area, to)
               : FillWith<ConstantValues<std::uint32_t>>(job, entry, area, to);
}

bool FillTriangle(const FillJob& job, const BinEntry& entry, TileBuffer& to) {
    const PassFormat& format = job.format;
    const bool is_affine = format.interpolation == Interpolation::affine;
    const SetupTriangle& t = job.batches[entry.batch].triangles[entry.index];
    const PixelRect& rect = to.drawn();
    const PixelRect part{std::max(rect.x0, t.bounds.x0),
                         std::max(rect.y0, t.bounds.y0),
                         std::min(rect.x1, t.bounds.x1),
                         std::min(rect.y1, t.bounds.y1)};
    Area area;
    if (part.is_empty() || !MakeArea(t, part, area)) return true;
    if (format.interpolants == 0 && format.constant) return FillConstant(job, entry, area, to);
    switch (format.store) {
        case Store::none:
            return FillWith<NoValues>(job, entry, area, to);
        case Store::f32:
            return is_affine ? FillWith<NumberValues<false>>(job, entry, area, to)
                             : FillWith<NumberValues<true>>(job, entry, area, to);
        default:
            break;
    }
    return format.interpolants == 1 ? FillCodes<1>(job, entry, area, to)
                                    : FillCodes<2>(job, entry, area, to);
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(FillTriangle);

bool fill_triangle(const FillJob& job, const BinEntry& entry, TileBuffer& buffer) {
    // A code that runs on the surface and has a constant is of no method.
    if (job.format.interpolation == Interpolation::perspective && job.format.constant) return false;
    // Steps over a tile, and the value of an edge that crosses it, then fit 31 bits.
    constexpr std::int64_t kLongest = std::int64_t{1} << (22 + kSubpixelBits);
    for (const EdgeFunction& e : job.batches[entry.batch].triangles[entry.index].edges) {
        if (std::abs(e.dx) > kLongest || std::abs(e.dy) > kLongest) return false;
    }
    return HWY_DYNAMIC_DISPATCH(FillTriangle)(job, entry, buffer);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
