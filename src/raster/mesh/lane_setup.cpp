#include <algorithm>
#include <cstring>
#include <limits>

#include "raster/mesh/lane_triangles.h"
#include "raster/pass/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;

#include "raster/mesh/lane_columns.inl"
#include "raster/mesh/lane_edges.inl"
#include "raster/mesh/lane_planes.inl"
#include "raster/mesh/lane_tables.inl"

#include "raster/mesh/lane_values.inl"

/// Numbers of the corners of triangles of one slot.
class CornerLookup {
  public:
    /// `entries` as a list has them; `is_real` where they are this slot's.
    HWY_INLINE CornerLookup(const LaneSource& source,
                            const LaneSlot& slot,
                            VI entries,
                            hn::Mask<DI> is_real)
        : records_(reinterpret_cast<const std::int32_t*>(source.records + slot.first_byte)),
          slot_(slot) {
        const DI d;
        triangle_ = hn::IfThenElseZero(is_real, hn::And(entries, hn::Set(d, 0xff)));
        const auto corners = hn::GatherIndex(d, records_ + slot.corners * slot.stride, triangle_);
        for (int k = 0; k < 3; ++k)
            index_[k] = CornerOf(corners, k);
        is_back_ = hn::And(is_real, hn::Lt(corners, hn::Zero(d)));
        has_front_ = hn::CountTrue(d, is_back_) != hn::CountTrue(d, is_real);
        has_back_ = !hn::AllFalse(d, is_back_);
    }

    HWY_INLINE VI Constants() const {
        return hn::GatherIndex(DI(), records_ + slot_.constants, triangle_);
    }

    /// One array of the records, or one for triangles seen from their front and one for the others.
    template <class Store>
    HWY_INLINE void ForEachCorner(std::size_t front, std::size_t back, const Store& store) const {
        const bool is_one = front == back || !has_back_;
        const VertexTable table(records_ + (has_front_ ? front : back) * slot_.stride);
        if (is_one || !has_front_) {
            for (int k = 0; k < 3; ++k)
                store(k, table.At(index_[k]));
            return;
        }
        const VertexTable of_back(records_ + back * slot_.stride);
        for (int k = 0; k < 3; ++k)
            store(k, hn::IfThenElse(is_back_, of_back.At(index_[k]), table.At(index_[k])));
    }

  private:
    const std::int32_t* records_;
    const LaneSlot& slot_;
    VI triangle_;
    VI index_[3];
    hn::Mask<DI> is_back_;
    bool has_front_;
    bool has_back_;
};

/// The corners of the first triangles from `at` on as long as they are of one slot and fit a
/// vector; returns how many.
HWY_INLINE std::size_t CollectSome(const LaneSource& source,
                                   std::size_t values,
                                   bool has_constants,
                                   const std::uint32_t* entries,
                                   std::size_t at,
                                   std::size_t count,
                                   LaneTriangles& out) {
    const DI d;
    const DF df;
    const std::uint32_t number = entries[at] >> 8;
    const LaneSlot& slot = source.slots[number];
    const auto some = hn::LoadU(d, reinterpret_cast<const std::int32_t*>(entries) + at);
    const auto is_same =
        hn::And(hn::Eq(hn::ShiftRight<8>(some), hn::Set(d, static_cast<std::int32_t>(number))),
                hn::FirstN(d, count - at));
    const CornerLookup lookup(source, slot, some, is_same);
    lookup.ForEachCorner(0, 0, [&](int k, VI v) { hn::StoreU(v, d, out.corners[k].x + at); });
    lookup.ForEachCorner(1, 1, [&](int k, VI v) { hn::StoreU(v, d, out.corners[k].y + at); });
    lookup.ForEachCorner(slot.q[0], slot.q[1], [&](int k, VI v) {
        hn::StoreU(hn::BitCast(df, v), df, out.corners[k].q + at);
    });
    for (std::size_t i = 0; i < values; ++i) {
        lookup.ForEachCorner(slot.values[0] + i, slot.values[1] + i, [&](int k, VI v) {
            hn::StoreU(hn::BitCast(df, v), df, out.corners[k].values[i] + at);
        });
    }
    if (has_constants) hn::StoreU(lookup.Constants(), d, out.constants + at);
    return hn::CountTrue(d, is_same);  // a slot's triangles stand together
}

/// Looks up the corners of at most LaneTriangles::kCount listed triangles, none of them of the
/// scalar path, with `values` values each: fills out.corners, whose last vector has numbers without
/// meaning in it, and out.constants if there are any.
void CollectCorners(const LaneSource& source,
                    std::size_t values,
                    bool has_constants,
                    std::span<const std::uint32_t> entries,
                    LaneTriangles& out) {
    alignas(64) std::uint32_t padded[LaneTriangles::kPadded];
    std::memcpy(padded, entries.data(), entries.size_bytes());
    std::fill_n(padded + entries.size(), kLanePad, 0U);
    for (std::size_t at = 0; at < entries.size();)
        at += CollectSome(source, values, has_constants, padded, at, entries.size(), out);
}

HWY_INLINE Corner LoadCorner(const LaneTriangles::Corners& from, std::size_t at) {
    const DI d;
    const DF df;
    Corner c;
    c.x = hn::Load(d, from.x + at);
    c.y = hn::Load(d, from.y + at);
    c.q = hn::Load(df, from.q + at);
    c.value = hn::Load(df, from.values[0] + at);
    c.Snap();
    return c;
}

/// The 9 numbers of three edges; returns where the triangle is thin.
HWY_INLINE hn::Mask<DI> SetUpEdges(const Corner (&c)[3],
                                   const Reference& ref,
                                   std::size_t at,
                                   LaneTriangles& out) {
    const DI d;
    const EdgeLanes edges = MakeEdges(c, ref);
    for (int k = 0; k < 3; ++k) {
        hn::Store(edges.at_ref[k], d, out.edge_at_ref[k] + at);
        hn::Store(edges.dx[k], d, out.edge_dx[k] + at);
        hn::Store(edges.dy[k], d, out.edge_dy[k] + at);
    }
    return edges.is_thin;
}

HWY_INLINE void SetUpBox(const Corner (&c)[3],
                         const PixelRect& drawn,
                         std::size_t at,
                         LaneTriangles& out) {
    const DI d;
    const auto to_centre = hn::Set(d, kSubpixels / 2 - 1);
    const auto first = [&](VI v) { return hn::ShiftRight<kSubpixelBits>(hn::Add(v, to_centre)); };
    const auto low = [](VI a, VI b, VI e) { return hn::Min(hn::Min(a, b), e); };
    const auto high = [](VI a, VI b, VI e) { return hn::Max(hn::Max(a, b), e); };
    const auto x0 = first(low(c[0].x_snapped, c[1].x_snapped, c[2].x_snapped));
    const auto x1 = first(high(c[0].x_snapped, c[1].x_snapped, c[2].x_snapped));
    const auto y0 = first(low(c[0].y_snapped, c[1].y_snapped, c[2].y_snapped));
    const auto y1 = first(high(c[0].y_snapped, c[1].y_snapped, c[2].y_snapped));
    hn::Store(hn::Max(x0, hn::Set(d, drawn.x0)), d, out.x0 + at);
    hn::Store(hn::Max(y0, hn::Set(d, drawn.y0)), d, out.y0 + at);
    hn::Store(hn::Min(x1, hn::Set(d, drawn.x1)), d, out.x1 + at);
    hn::Store(hn::Min(y1, hn::Set(d, drawn.y1)), d, out.y1 + at);
}

template <class D, class Plane, class Planes>
HWY_INLINE void StorePlane(D d, const Plane& p, std::size_t at, Planes& out) {
    hn::Store(p.at_ref, d, out.at_ref + at);
    hn::Store(p.dx, d, out.dx + at);
    hn::Store(p.dy, d, out.dy + at);
    hn::Store(p.low, d, out.low + at);
    hn::Store(p.high, d, out.high + at);
}

void SetUpLanes(const PassFormat& format,
                const LaneSource& source,
                std::span<const std::uint32_t> entries,
                const PixelRect& drawn,
                const LaneDepthBias& depth_bias,
                LaneTriangles& out) {
    const DI d;
    const DF df;
    const auto values = static_cast<std::size_t>(format.interpolants);
    CollectCorners(source, values, format.constant, entries, out);
    out.count = entries.size();
    const CodeScale scale(format);
    for (std::size_t at = 0; at < out.count; at += hn::Lanes(d)) {
        Corner c[3];
        for (int k = 0; k < 3; ++k)
            c[k] = LoadCorner(out.corners[k], at);
        const Reference ref(c[0]);
        hn::Store(ref.x, d, out.ref_x + at);
        hn::Store(ref.y, d, out.ref_y + at);
        SetUpBox(c, drawn, at, out);
        const auto is_thin = SetUpEdges(c, ref, at, out);
        const PlaneLanes planes = MakePlanes(c, ref);
        StorePlane(df, MakeDepth(planes, c, depth_bias), at, out.q);
        auto needs_limits = is_thin;
        const auto set_up = [&](VF v0, VF v1, VF v2, std::size_t i) {
            if (format.store == Store::f32) {
                const auto limit = hn::RebindMask(df, is_thin);
                StorePlane(df, MakeNumbers(planes, v0, v1, v2, limit), at, out.numbers[i]);
                return;
            }
            const CodePlane codes = MakeCodes(planes, v0, v1, v2, is_thin, scale);
            StorePlane(d, codes, at, out.codes[i]);
            needs_limits = hn::Or(needs_limits, codes.may_leave);
        };
        if (values > 0) set_up(c[0].value, c[1].value, c[2].value, 0);
        for (std::size_t i = 1; i < values; ++i) {
            set_up(hn::Load(df, out.corners[0].values[i] + at),
                   hn::Load(df, out.corners[1].values[i] + at),
                   hn::Load(df, out.corners[2].values[i] + at),
                   i);
        }
        hn::Store(hn::VecFromMask(d, needs_limits), d, out.needs_limits + at);
    }
}

/// One edge of a vector of triangles, in a column of pixels: at the centre of its top row that lies
/// farthest in.
struct ColumnEdge {
    VI at;
    VI step;               ///< to the next column
    VF rows;               ///< -1 over its step from row to row
    hn::Mask<DF> is_from;  ///< inside from some row on; else up to some row

    HWY_INLINE ColumnEdge(const LaneTriangles& t, int k, std::size_t i, VI x, VI y) {
        const DI d;
        const DF df;
        const auto zero = hn::Zero(d);
        const auto dx = hn::Load(d, t.edge_dx[k] + i);
        const auto dy = hn::Load(d, t.edge_dy[k] + i);
        const auto right = hn::IfThenElseZero(hn::Gt(dx, zero), hn::Set(d, kColumn_px - 1));
        at = hn::Add(hn::Load(d, t.edge_at_ref[k] + i),
                     hn::Add(hn::Mul(dx, hn::Add(x, right)), hn::Mul(dy, y)));
        step = hn::Mul(dx, hn::Set(d, kColumn_px));
        // A level edge is one that hardly runs down: all of the column or nothing.
        const auto level = hn::Set(df, -0x1p-20F);
        const auto is_level = hn::RebindMask(df, hn::Eq(dy, zero));
        const auto down = hn::IfThenElse(is_level, level, hn::ConvertTo(df, dy));
        rows = hn::Neg(hn::ApproximateReciprocal(down));
        is_from = hn::RebindMask(df, hn::Gt(dy, zero));
    }

    /// Takes from the rows what it leaves outside, and goes on to the next column.
    HWY_INLINE void Cut(VF& begin, VF& end) {
        const DF df;
        // Whole numbers: a half more is inside all the same, and 0 is no special case.
        const auto row = hn::Mul(hn::Add(hn::ConvertTo(df, at), hn::Set(df, 0.5F)), rows);
        begin = hn::IfThenElse(is_from, hn::Max(begin, row), begin);
        end = hn::IfThenElse(is_from, end, hn::Min(end, row));
        at = hn::Add(at, step);
    }
};

/// The rows of a vector of triangles, column by column.
HWY_INLINE void CutRows(LaneTriangles& t, std::size_t i, VI first_x, VI x1, VI y0, VI height) {
    const DI d;
    const DF df;
    const auto x = hn::Sub(first_x, hn::Load(d, t.ref_x + i));
    const auto y = hn::Sub(y0, hn::Load(d, t.ref_y + i));
    ColumnEdge edges[3] = {{t, 0, i, x, y}, {t, 1, i, x, y}, {t, 2, i, x, y}};
    const auto most = hn::ConvertTo(df, height);
    // A reciprocal is off by 1/2048 at most, a row by 1/16.
    constexpr float kMargin = 0.125F;
    const auto first_from = hn::Set(df, 1 - kMargin);
    const auto end_from = hn::Set(df, 1 + kMargin);
    const auto row_of = [&](VF row) {
        return hn::ConvertTo(d, hn::Min(hn::Max(row, hn::Zero(df)), most));
    };
    auto left = first_x;
    for (std::size_t column = 0; column < LaneTriangles::kColumns; ++column) {
        auto begin = hn::Zero(df);
        auto end = most;
        for (ColumnEdge& edge : edges)
            edge.Cut(begin, end);
        const auto first = row_of(hn::Add(begin, first_from));
        const auto behind = row_of(hn::Add(end, end_from));
        hn::Store(hn::Or(first, hn::ShiftLeft<16>(behind)), d, t.rows[column] + i);
        left = hn::Add(left, hn::Set(d, kColumn_px));
        if (hn::AllFalse(d, hn::Lt(left, x1))) break;
    }
}

void FindRows(LaneTriangles& t) {
    const DI d;
    const auto column = hn::Set(d, kColumn_px);
    for (std::size_t i = 0; i < t.count; i += hn::Lanes(d)) {
        const auto x0 = hn::Load(d, t.x0 + i);
        const auto x1 = hn::Load(d, t.x1 + i);
        const auto y0 = hn::Load(d, t.y0 + i);
        const auto width = hn::Sub(x1, x0);
        const auto height = hn::Sub(hn::Load(d, t.y1 + i), y0);
        // Columns start where vectors are aligned. What fits one is not cut in two for that.
        const auto aligned = hn::And(x0, hn::Set(d, -kColumn_px));
        const auto is_cut =
            hn::And(hn::Gt(hn::Sub(x1, aligned), column), hn::Not(hn::Gt(width, column)));
        const auto first_x = hn::IfThenElse(is_cut, hn::Sub(x1, column), aligned);
        hn::Store(first_x, d, t.first_x + i);
        if (!kKnowsRows) continue;
        const auto is_real = hn::FirstN(d, t.count - i);
        const auto larger = hn::Gt(hn::Max(width, height), hn::Set(d, 2));
        if (hn::AllFalse(d, hn::And(larger, is_real))) {  // nothing to leave out
            hn::Store(hn::ShiftLeft<16>(height), d, t.rows[0] + i);
            continue;
        }
        CutRows(t, i, first_x, hn::IfThenElse(is_real, x1, first_x), y0, height);
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(SetUpLanes);
HWY_EXPORT(FindRows);

void set_up_lanes(const PassFormat& format,
                  const LaneSource& source,
                  std::span<const std::uint32_t> entries,
                  const PixelRect& drawn,
                  const LaneDepthBias& depth_bias,
                  LaneTriangles& out) {
    HWY_DYNAMIC_DISPATCH(SetUpLanes)(format, source, entries, drawn, depth_bias, out);
    find_rows(out);
}

void find_rows(LaneTriangles& triangles) {
    HWY_DYNAMIC_DISPATCH(FindRows)(triangles);
}

bool lanes_can_draw(const PassFormat& format) {
    if (format.interpolation != Interpolation::affine) return false;
    if (format.constant) {
        const bool is_whole = format.store == Store::u8 || format.store == Store::u32;
        return is_whole && format.interpolants == 0;
    }
    const int k = format.interpolants;
    return (format.store == Store::none && k == 0) ||
           (format.store == Store::u8 && (k == 1 || k == 2)) ||
           (format.store == Store::u16 && k == 1) || (format.store == Store::f32 && k == 4);
}

bool lanes_can_hold(const PassFormat& format, float least, float greatest) {
    switch (format.store) {
        case Store::u8:
            return least >= -4000 && greatest <= 8000;
        case Store::u16:
            return least >= -1 && greatest <= 66000;
        default:
            return least >= -0x1p20F && greatest <= 0x1p20F;
    }
}

}  // namespace ink::raster
#endif  // HWY_ONCE
