#include "raster/lane_triangles.h"
#include "raster/tile_buffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/lane_fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Eight pixels of a row: triangles that lanes set up are small, and eight lie in one cache line of
// depth at an address that every other triangle uses too, so that stores are forwarded to loads.
using DI = hn::CappedTag<std::int32_t, 8>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;
using MI = hn::Mask<DI>;

/// at + d * n modulo 2^32.
HWY_INLINE std::int32_t Along(std::int32_t at, std::int32_t d, std::int32_t n) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(at) +
                                     static_cast<std::uint32_t>(d) * static_cast<std::uint32_t>(n));
}

/// Nothing besides depth.
class NoLanes {
  public:
    NoLanes(const LaneTriangles&, std::size_t, TileBuffer&) {}
    HWY_INLINE void StartColumn(VI, VF, int, int) {}
    HWY_INLINE void Write(int, std::ptrdiff_t, MI) {}
    HWY_INLINE void NextRow() {}
};

/// kCount codes of type T.
template <class T, int kCount, int kFraction>
class CodeLanes {
  public:
    CodeLanes(const LaneTriangles& t, std::size_t i, TileBuffer& to) : t_(t), i_(i) {
        for (int k = 0; k < kCount; ++k)
            plane_[k] = to.plane_row<T>(k, 0);
    }
    HWY_INLINE void StartColumn(VI from_ref, VF, int, int dy) {
        const DI d;
        for (int k = 0; k < kCount; ++k) {
            const LaneTriangles::Codes& c = t_.codes[k];
            at_[k] = hn::Add(hn::Set(d, Along(c.at_ref[i_], c.dy[i_], dy)),
                             hn::Mul(hn::Set(d, c.dx[i_]), from_ref));
            step_[k] = hn::Set(d, c.dy[i_]);
            low_[k] = hn::Set(d, c.low[i_]);
            high_[k] = hn::Set(d, c.high[i_]);
        }
    }
    HWY_INLINE void Write(int, std::ptrdiff_t offset, MI mask) {
        const DI d;
        const hn::RebindToUnsigned<DI> du;
        const hn::Rebind<T, DI> dt;
        for (int k = 0; k < kCount; ++k) {
            const auto limited = hn::Min(hn::Max(at_[k], low_[k]), high_[k]);
            const auto code = hn::ShiftRight<kFraction>(limited);
            const auto old = hn::PromoteTo(d, hn::LoadU(dt, plane_[k] + offset));
            const auto kept = hn::BitCast(du, hn::IfThenElse(mask, code, old));
            hn::StoreU(hn::TruncateTo(dt, kept), dt, plane_[k] + offset);
        }
    }
    HWY_INLINE void NextRow() {
        for (int k = 0; k < kCount; ++k)
            at_[k] = hn::Add(at_[k], step_[k]);
    }

  private:
    const LaneTriangles& t_;
    std::size_t i_;
    T* plane_[kCount];
    VI at_[kCount], step_[kCount], low_[kCount], high_[kCount];
};

/// Four floats.
class NumberLanes {
  public:
    NumberLanes(const LaneTriangles& t, std::size_t i, TileBuffer& to) : t_(t), i_(i) {
        for (int k = 0; k < kMaxPlanes; ++k)
            plane_[k] = to.plane_row<float>(k, 0);
    }
    HWY_INLINE void StartColumn(VI, VF from_ref, int, int dy) {
        dy_ = dy;
        for (int k = 0; k < kMaxPlanes; ++k)
            ramp_[k] = hn::Mul(hn::Set(DF(), t_.numbers[k].dx[i_]), from_ref);
    }
    HWY_INLINE void Write(int, std::ptrdiff_t offset, MI mask) {
        const DF df;
        const auto dy = static_cast<float>(dy_);
        for (int k = 0; k < kMaxPlanes; ++k) {
            const LaneTriangles::Numbers& n = t_.numbers[k];
            const float row = n.at_ref[i_] + n.dy[i_] * dy;
            const auto v = hn::Add(hn::Set(df, row), ramp_[k]);
            const auto limited =
                hn::Min(hn::Max(v, hn::Set(df, n.low[i_])), hn::Set(df, n.high[i_]));
            float* to = plane_[k] + offset;
            hn::StoreU(hn::IfThenElse(hn::RebindMask(df, mask), limited, hn::LoadU(df, to)), df, to);
        }
    }
    HWY_INLINE void NextRow() { ++dy_; }

  private:
    const LaneTriangles& t_;
    std::size_t i_;
    int dy_ = 0;
    float* plane_[kMaxPlanes];
    VF ramp_[kMaxPlanes];
};

template <class Values>
HWY_INLINE void FillTriangle(const LaneTriangles& t, std::size_t i, TileBuffer& to) {
    const DI d;
    const DF df;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const int y0 = t.y0[i];
    const int rows = t.y1[i] - y0;
    const int dy = y0 - t.ref_y[i];
    const float q_ref = t.q.at_ref[i];
    const float q_dy = t.q.dy[i];
    const auto q_low = hn::Set(df, t.q.low[i]);
    const auto q_high = hn::Set(df, t.q.high[i]);
    const auto step0 = hn::Set(d, t.edge_dy[0][i]);
    const auto step1 = hn::Set(d, t.edge_dy[1][i]);
    const auto step2 = hn::Set(d, t.edge_dy[2][i]);
    const auto minus_one = hn::Set(d, -1);
    float* const depth = to.depth_row<float>(0);
    Values values(t, i, to);
    for (int x = t.x0[i] & -lanes; x < t.x1[i]; x += lanes) {
        const auto from_ref = hn::Iota(d, x - t.ref_x[i]);
        const auto from_ref_f = hn::ConvertTo(df, from_ref);
        const auto start = [&](int k) {
            return hn::Add(hn::Set(d, Along(t.edge_at_ref[k][i], t.edge_dy[k][i], dy)),
                           hn::Mul(hn::Set(d, t.edge_dx[k][i]), from_ref));
        };
        auto e0 = start(0);
        auto e1 = start(1);
        auto e2 = start(2);
        const auto q_ramp = hn::Mul(hn::Set(df, t.q.dx[i]), from_ref_f);
        values.StartColumn(from_ref, from_ref_f, x, dy);
        std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y0) * kTileStride + x;
        for (int row = 0; row < rows; ++row, offset += kTileStride) {
            const float q_row = q_ref + q_dy * static_cast<float>(dy + row);
            const auto q =
                hn::Min(hn::Max(hn::Add(hn::Set(df, q_row), q_ramp), q_low), q_high);
            const auto is_inside = hn::Gt(hn::Or(hn::Or(e0, e1), e2), minus_one);
            const auto seen = hn::IfThenElseZero(hn::RebindMask(df, is_inside), q);
            const auto old = hn::LoadU(df, depth + offset);
            hn::StoreU(hn::Max(seen, old), df, depth + offset);
            values.Write(row, offset, hn::RebindMask(d, hn::Gt(seen, old)));
            e0 = hn::Add(e0, step0);
            e1 = hn::Add(e1, step1);
            e2 = hn::Add(e2, step2);
            values.NextRow();
        }
    }
}

template <class Values>
void Fill(const LaneTriangles& triangles, TileBuffer& to) {
    for (std::size_t i = 0; i < triangles.count; ++i)
        FillTriangle<Values>(triangles, i, to);
}

void FillLanes(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to) {
    switch (format.store) {
        case Store::u8:
            return format.interpolants == 1
                       ? Fill<CodeLanes<std::uint8_t, 1, 16>>(triangles, to)
                       : Fill<CodeLanes<std::uint8_t, 2, 16>>(triangles, to);
        case Store::u16:
            return Fill<CodeLanes<std::uint16_t, 1, 14>>(triangles, to);
        case Store::f32:
            return Fill<NumberLanes>(triangles, to);
        default:
            return Fill<NoLanes>(triangles, to);
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(FillLanes);

void fill_lanes(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to) {
    HWY_DYNAMIC_DISPATCH(FillLanes)(format, triangles, to);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
