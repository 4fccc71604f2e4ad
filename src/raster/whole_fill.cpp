#include "raster/whole_fill.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/whole_fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "raster/whole_lanes.inl"

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

/// One triangle in one tile, column of vectors by column of vectors.
template <class Depth, class Values>
class WholeFill {
  public:
    WholeFill(const FillJob& job, const WholeTriangle& triangle, const Area& area, TileBuffer& to)
        : t_(triangle.setup()),
          area_(area),
          depth_(t_, QuantisedDepth(job.format.depth, job.input.near, job.input.far)),
          values_(triangle, to),
          depth_plane_(to.depth_row<typename Depth::Value>(0)) {
        q_.fill(t_.q, triangle.first_row(), triangle.rows);
        // Vectors start where cache lines do.
        const int origin = to.own().x0 - kTileMargin_px;
        for (int x = area.rect.x0 - (area.rect.x0 - origin) % kLanes; x < area.rect.x1; x += kLanes)
            Column(x);
    }

  private:
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));

    HWY_INLINE void Column(int x) {
        const DI d;
        const PixelRect& r = area_.rect;
        const int first = x - r.x0;
        const ColumnRows rows =
            RowsOf(area_, std::max(first, 0), std::min(first + kLanes, r.x1 - r.x0) - 1);
        if (rows.begin >= rows.end) return;
        const auto ramp = hn::Load(d, kRamp);
        const auto across = hn::Add(ramp, hn::Set(d, first));
        const auto in_rect =
            hn::And(hn::Gt(across, hn::Set(d, -1)), hn::Lt(across, hn::Set(d, r.x1 - r.x0)));
        for (int k = 0; k < 3; ++k)
            edge_[k] = hn::Add(hn::Set(d, area_.at[k]), hn::Mul(hn::Set(d, area_.dx[k]), across));
        const auto from_ref = hn::Add(ramp, hn::Set(d, x - t_.ref_x));
        const auto from_ref_wide = Widen(DD(), from_ref);
        q_ramp_ = Ramp(t_.q, from_ref_wide);
        values_.StartColumn(from_ref, from_ref_wide);
        x_ = x;
        Rows<true>(rows.begin, rows.inside_begin, in_rect);
        Rows<false>(rows.inside_begin, rows.inside_end, in_rect);
        Rows<true>(rows.inside_end, rows.end, in_rect);
    }

    template <bool kTestsEdges>
    HWY_INLINE void Rows(int begin, int end, MI in_rect) {
        if (begin >= end) return;
        const DI d;
        VI edge[3], step[3];
        for (int k = 0; kTestsEdges && k < 3; ++k) {
            edge[k] = hn::Add(edge_[k], hn::Set(d, area_.dy[k] * begin));
            step[k] = hn::Set(d, area_.dy[k]);
        }
        values_.StartRows(begin);
        std::ptrdiff_t at = static_cast<std::ptrdiff_t>(area_.rect.y0 + begin) * kTileStride + x_;
        for (int row = begin; row < end; ++row, at += kTileStride) {
            auto mask = in_rect;
            if (kTestsEdges) {
                mask = hn::And(mask, hn::Gt(hn::Or3(edge[0], edge[1], edge[2]), hn::Set(d, -1)));
                for (int k = 0; k < 3; ++k)
                    edge[k] = hn::Add(edge[k], step[k]);
            }
            const auto q_row = q_.at(row);
            const auto q = q_ramp_.map([&](VD part) { return hn::Add(q_row, part); });
            const auto is_nearer = depth_.Test(q, mask, depth_plane_ + at);
            values_.Write(at, q, is_nearer);
        }
    }

    const SetupTriangle& t_;
    const Area& area_;
    Depth depth_;
    Values values_;
    typename Depth::Value* depth_plane_;
    RowStarts q_;
    Doubles q_ramp_;
    VI edge_[3];
    int x_ = 0;
};

template <class Values>
bool FillWith(const FillJob& job, const BinEntry& entry, const Area& area, TileBuffer& to) {
    const Batch& batch = job.batches[entry.batch];
    const std::uint32_t constant =
        job.format.constant ? job.input.constants[batch.triangles[entry.index].triangle] : 0;
    const WholeTriangle triangle{
        job.format, batch, entry.index, area.rect.y0, area.rect.y1 - area.rect.y0, constant};
    if (job.format.depth == DepthFormat::q32) {
        WholeFill<FloatDepthLanes, Values>(job, triangle, area, to);
    } else {
        WholeFill<StepDepthLanes, Values>(job, triangle, area, to);
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

bool FillWhole(const FillJob& job, const BinEntry& entry, const PixelRect& rect, TileBuffer& to) {
    const PassFormat& format = job.format;
    const bool is_affine = format.interpolation == Interpolation::affine;
    const SetupTriangle& t = job.batches[entry.batch].triangles[entry.index];
    const PixelRect part{std::max(rect.x0, t.bounds.x0),
                         std::max(rect.y0, t.bounds.y0),
                         std::min(rect.x1, t.bounds.x1),
                         std::min(rect.y1, t.bounds.y1)};
    Area area;
    if (part.is_empty() || !MakeArea(t, part, area)) return true;
    switch (format.store) {
        case Store::none:
            return FillWith<NoValues>(job, entry, area, to);
        case Store::u32:
            return FillWith<ConstantValues>(job, entry, area, to);
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

HWY_EXPORT(FillWhole);

bool fill_whole(const FillJob& job,
                const BinEntry& entry,
                const PixelRect& rect,
                TileBuffer& buffer) {
    // A code that runs on the surface and has a constant is of no method.
    if (job.format.interpolation == Interpolation::perspective && job.format.constant) return false;
    // Steps over a tile, and the value of an edge that crosses it, then fit 31 bits.
    constexpr std::int64_t kLongest = std::int64_t{1} << (22 + kSubpixelBits);
    for (const EdgeFunction& e : job.batches[entry.batch].triangles[entry.index].edges) {
        if (std::abs(e.dx) > kLongest || std::abs(e.dy) > kLongest) return false;
    }
    return HWY_DYNAMIC_DISPATCH(FillWhole)(job, entry, rect, buffer);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
