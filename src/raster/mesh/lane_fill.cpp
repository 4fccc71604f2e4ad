#include "raster/mesh/lane_triangles.h"
#include "raster/pass/tile_buffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_fill.cpp"
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

#include "raster/mesh/lane_columns.inl"
#include "raster/pass/narrow_constant.inl"

/// Pixels of a vector, from its first.
alignas(64) constexpr std::int32_t kRamp[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/// at + d * n modulo 2^32.
HWY_INLINE std::int32_t Along(std::int32_t at, std::int32_t d, std::int32_t n) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(at) +
                                     static_cast<std::uint32_t>(d) * static_cast<std::uint32_t>(n));
}

/// Depth as a float.
struct FloatDepthLanes {
    using Value = float;
    static constexpr bool kIsLimited = false;  ///< at every triangle
    /// Writes what is nearer where `mask` allows it; returns where that was.
    static HWY_INLINE MI Test(VF q, MI mask, float* to) {
        const DF df;
        const auto seen = hn::IfThenElseZero(hn::RebindMask(df, mask), q);
        const auto old = hn::LoadU(df, to);
        hn::StoreU(hn::Max(seen, old), df, to);
        return hn::RebindMask(DI(), hn::Gt(seen, old));
    }
};

/// Depth as a whole step: between those of the corners, which the format has.
struct StepDepthLanes {
    using Value = std::uint32_t;
    static constexpr bool kIsLimited = true;
    static HWY_INLINE MI Test(VF step, MI mask, std::uint32_t* row) {
        const DI d;
        const auto seen = hn::IfThenElseZero(mask, hn::ConvertTo(d, step));
        auto* const to = reinterpret_cast<std::int32_t*>(row);  // at most 2^24 - 1
        const auto old = hn::LoadU(d, to);
        hn::StoreU(hn::Max(seen, old), d, to);
        return hn::Gt(seen, old);
    }
};

/// Nothing besides depth.
class NoLanes {
  public:
    NoLanes(const LaneTriangles&, TileBuffer&) {}
    HWY_INLINE void StartTriangle(std::size_t) {}
    HWY_INLINE void StartColumn(VI, VF, int) {}
    template <bool kLimits>
    HWY_INLINE void Write(std::ptrdiff_t, VF, MI) {}
};

/// The triangle's constant, as narrow as the store.
template <class T>
class ConstantLanes {
  public:
    ConstantLanes(const LaneTriangles& t, TileBuffer& to) : t_(t), plane_(to.plane_row<T>(0, 0)) {}
    HWY_INLINE void StartTriangle(std::size_t i) {
        constant_ = NarrowConstant<T, DI>(static_cast<std::uint32_t>(t_.constants[i]));
    }
    HWY_INLINE void StartColumn(VI, VF, int) {}
    template <bool kLimits>
    HWY_INLINE void Write(std::ptrdiff_t offset, VF, MI mask) {
        constant_.Put(mask, plane_ + offset);
    }

  private:
    const LaneTriangles& t_;
    T* plane_;
    NarrowConstant<T, DI> constant_;
};

/// kCount codes with kFraction bits after the point.
template <int kCount, int kFraction>
class CodeLanes {
  public:
    CodeLanes(const LaneTriangles& t, TileBuffer& to) : t_(t) {
        for (int k = 0; k < kCount; ++k)
            plane_[k] = reinterpret_cast<std::int32_t*>(to.code_row(k, 0));
    }
    HWY_INLINE void StartTriangle(std::size_t i) { i_ = i; }
    HWY_INLINE void StartColumn(VI from_ref, VF, int dy) {
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
    template <bool kLimits>
    HWY_INLINE void Write(std::ptrdiff_t offset, VF, MI mask) {
        const DI d;
        for (int k = 0; k < kCount; ++k) {
            const auto limited = kLimits ? hn::Min(hn::Max(at_[k], low_[k]), high_[k]) : at_[k];
            const auto code = hn::ShiftRight<kFraction>(limited);
            std::int32_t* to = plane_[k] + offset;
            hn::StoreU(hn::IfThenElse(mask, code, hn::LoadU(d, to)), d, to);
            at_[k] = hn::Add(at_[k], step_[k]);
        }
    }

  private:
    const LaneTriangles& t_;
    std::size_t i_ = 0;
    std::int32_t* plane_[kCount];
    VI at_[kCount], step_[kCount], low_[kCount], high_[kCount];
};

/// Four floats.
class NumberLanes {
  public:
    NumberLanes(const LaneTriangles& t, TileBuffer& to) : t_(t) {
        for (int k = 0; k < kMaxPlanes; ++k)
            plane_[k] = to.plane_row<float>(k, 0);
    }
    HWY_INLINE void StartTriangle(std::size_t i) {
        const DF df;
        for (int k = 0; k < kMaxPlanes; ++k) {
            const LaneTriangles::Numbers& n = t_.numbers[k];
            at_ref_[k] = hn::Set(df, n.at_ref[i]);
            dx_[k] = hn::Set(df, n.dx[i]);
            dy_[k] = hn::Set(df, n.dy[i]);
            low_[k] = hn::Set(df, n.low[i]);
            high_[k] = hn::Set(df, n.high[i]);
        }
    }
    HWY_INLINE void StartColumn(VI, VF from_ref, int) {
        for (int k = 0; k < kMaxPlanes; ++k)
            ramp_[k] = hn::Mul(dx_[k], from_ref);
    }
    template <bool kLimits>
    HWY_INLINE void Write(std::ptrdiff_t offset, VF rows_from_ref, MI mask) {
        const DF df;
        const auto kept = hn::RebindMask(df, mask);
        for (int k = 0; k < kMaxPlanes; ++k) {
            const auto row = hn::Add(at_ref_[k], hn::Mul(dy_[k], rows_from_ref));
            auto v = hn::Add(row, ramp_[k]);
            if (kLimits) v = hn::Min(hn::Max(v, low_[k]), high_[k]);
            float* to = plane_[k] + offset;
            hn::StoreU(hn::IfThenElse(kept, v, hn::LoadU(df, to)), df, to);
        }
    }

  private:
    const LaneTriangles& t_;
    float* plane_[kMaxPlanes];
    VF at_ref_[kMaxPlanes], dx_[kMaxPlanes], dy_[kMaxPlanes];
    VF low_[kMaxPlanes], high_[kMaxPlanes], ramp_[kMaxPlanes];
};

/// Rows y0 .. y1 - 1 of a column.
struct Rows {
    int y0;
    int y1;
};
HWY_INLINE Rows RowsOf(const LaneTriangles& t, std::size_t i, std::size_t column) {
    if (!kKnowsRows) return {t.y0[i], t.y1[i]};
    const std::int32_t rows = t.rows[column][i];
    return {t.y0[i] + (rows & 0xffff), t.y0[i] + (rows >> 16)};
}

template <class Depth, bool kLimits, class Values>
HWY_INLINE void FillTriangle(const LaneTriangles& t,
                             std::size_t i,
                             typename Depth::Value* depth,
                             Values& values) {
    const DI d;
    const DF df;
    const int x1 = t.x1[i];
    std::size_t column = 0;
    const auto q_ref = hn::Set(df, t.q.at_ref[i]);
    const auto q_dy = hn::Set(df, t.q.dy[i]);
    const auto one = hn::Set(df, 1);
    const auto q_low = hn::Set(df, t.q.low[i]);
    const auto q_high = hn::Set(df, t.q.high[i]);
    const auto step0 = hn::Set(d, t.edge_dy[0][i]);
    const auto step1 = hn::Set(d, t.edge_dy[1][i]);
    const auto step2 = hn::Set(d, t.edge_dy[2][i]);
    const auto minus_one = hn::Set(d, -1);
    values.StartTriangle(i);
    for (int x = t.first_x[i]; x < x1; x += kColumn_px, ++column) {
        const auto [y0, y1] = RowsOf(t, i, column);
        if (y0 >= y1) continue;
        const int dy = y0 - t.ref_y[i];
        const auto from_ref = hn::Add(hn::Load(d, kRamp), hn::Set(d, x - t.ref_x[i]));
        const auto from_ref_f = hn::ConvertTo(df, from_ref);
        const auto start = [&](int k) {
            return hn::Add(hn::Set(d, Along(t.edge_at_ref[k][i], t.edge_dy[k][i], dy)),
                           hn::Mul(hn::Set(d, t.edge_dx[k][i]), from_ref));
        };
        auto e0 = start(0);
        auto e1 = start(1);
        auto e2 = start(2);
        const auto q_ramp = hn::Mul(hn::Set(df, t.q.dx[i]), from_ref_f);
        values.StartColumn(from_ref, from_ref_f, dy);
        auto row_from_ref = hn::Set(df, static_cast<float>(dy));  // whole numbers: no rounding
        std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y0) * kTileStride + x;
        for (int y = y0; y < y1; ++y, offset += kTileStride) {
            const auto q_row = hn::Add(q_ref, hn::Mul(q_dy, row_from_ref));
            auto q = hn::Add(q_row, q_ramp);
            if (kLimits || Depth::kIsLimited) q = hn::Min(hn::Max(q, q_low), q_high);
            const auto is_inside = hn::Gt(hn::Or3(e0, e1, e2), minus_one);
            values.template Write<kLimits>(
                offset, row_from_ref, Depth::Test(q, is_inside, depth + offset));
            e0 = hn::Add(e0, step0);
            e1 = hn::Add(e1, step1);
            e2 = hn::Add(e2, step2);
            row_from_ref = hn::Add(row_from_ref, one);
        }
    }
}

template <class Depth, class Values>
void Fill(const LaneTriangles& triangles, TileBuffer& to) {
    auto* const depth = to.depth_row<typename Depth::Value>(0);
    Values values(triangles, to);
    for (std::size_t i = 0; i < triangles.count; ++i) {
        triangles.needs_limits[i] != 0 ? FillTriangle<Depth, true>(triangles, i, depth, values)
                                       : FillTriangle<Depth, false>(triangles, i, depth, values);
    }
}

template <class Depth>
void FillConstants(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to) {
    format.store == Store::u8 ? Fill<Depth, ConstantLanes<std::uint8_t>>(triangles, to)
                              : Fill<Depth, ConstantLanes<std::uint32_t>>(triangles, to);
}

template <class Depth>
void FillStore(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to) {
    if (format.constant) return FillConstants<Depth>(format, triangles, to);
    switch (format.store) {
        case Store::u8:
            return format.interpolants == 1 ? Fill<Depth, CodeLanes<1, 16>>(triangles, to)
                                            : Fill<Depth, CodeLanes<2, 16>>(triangles, to);
        case Store::u16:
            return Fill<Depth, CodeLanes<1, 14>>(triangles, to);
        case Store::f32:
            return Fill<Depth, NumberLanes>(triangles, to);
        default:
            return Fill<Depth, NoLanes>(triangles, to);
    }
}

void FillLanes(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to) {
    format.depth == DepthFormat::q32 ? FillStore<FloatDepthLanes>(format, triangles, to)
                                     : FillStore<StepDepthLanes>(format, triangles, to);
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
