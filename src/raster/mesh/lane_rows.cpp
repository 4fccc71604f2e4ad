#include "raster/mesh/lane_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_rows.cpp"
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

HWY_EXPORT(FindRows);

void find_rows(LaneTriangles& triangles) {
    HWY_DYNAMIC_DISPATCH(FindRows)(triangles);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
