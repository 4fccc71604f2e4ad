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

// Planes are doubles and 64-bit integers, as set_up left them.
using DD = hn::CappedTag<double, 8>;
using VD = hn::Vec<DD>;
using DL = hn::Rebind<std::int64_t, DD>;
using VL = hn::Vec<DL>;
using DF = hn::Rebind<float, DD>;
using VF = hn::Vec<DF>;
using DI = hn::Rebind<std::int32_t, DD>;
using VI = hn::Vec<DI>;
using MI = hn::Mask<DI>;

alignas(64) constexpr std::int32_t kRamp[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/// A square of pixels that a triangle covers in part or whole, edges relative to (x0, y0).
struct Square {
    PixelRect rect;
    bool is_inside = false;  ///< every centre is
    std::int32_t at[3] = {};
    std::int32_t dx[3] = {};
    std::int32_t dy[3] = {};
};

/// False where some edge has all of the rectangle outside.
bool MakeSquare(const SetupTriangle& t, const PixelRect& rect, Square& square) {
    square.rect = rect;
    square.is_inside = true;
    for (int k = 0; k < 3; ++k) {
        const EdgeFunction& e = t.edges[static_cast<std::size_t>(k)];
        const int x_most = e.dx > 0 ? rect.x1 - 1 : rect.x0;
        const int y_most = e.dy > 0 ? rect.y1 - 1 : rect.y0;
        if (e.at(x_most, y_most) < 0) return false;
        const int x_least = e.dx > 0 ? rect.x0 : rect.x1 - 1;
        const int y_least = e.dy > 0 ? rect.y0 : rect.y1 - 1;
        square.at[k] = square.dx[k] = square.dy[k] = 0;
        if (e.at(x_least, y_least) >= 0) continue;
        square.is_inside = false;
        // It crosses the square, so the value fits; steps are whole multiples of 256.
        square.at[k] = static_cast<std::int32_t>(e.at(rect.x0, rect.y0) >> kSubpixelBits);
        square.dx[k] = static_cast<std::int32_t>(e.dx >> kSubpixelBits);
        square.dy[k] = static_cast<std::int32_t>(e.dy >> kSubpixelBits);
    }
    return true;
}

struct FloatDepthLanes {
    explicit FloatDepthLanes(const FillJob&) {}
    using Value = float;
    /// Writes what is nearer; returns where.
    HWY_INLINE MI Test(VD q, MI inside, float* row) const {
        const DF df;
        const auto seen = hn::IfThenElseZero(hn::RebindMask(df, inside), hn::DemoteTo(df, q));
        const auto old = hn::LoadU(df, row);
        hn::StoreU(hn::Max(seen, old), df, row);
        return hn::RebindMask(DI(), hn::Gt(seen, old));
    }
};

struct StepDepthLanes {
    explicit StepDepthLanes(const FillJob& job)
        : depth(job.format.depth, job.input.near, job.input.far) {}
    using Value = std::uint32_t;
    QuantisedDepth depth;
    HWY_INLINE MI Test(VD q, MI inside, std::uint32_t* row) const {
        const DD dd;
        const DI di;
        // As QuantisedDepth::of: below 1 (or no number) is 1, beyond the last step is the last.
        const auto z = hn::Add(hn::Mul(q, hn::Set(dd, depth.scale())), hn::Set(dd, depth.offset()));
        const auto one = hn::Set(dd, 1);
        const auto some = hn::IfThenElse(hn::Ge(z, one), z, one);
        const auto step = hn::DemoteTo(di, hn::Min(some, hn::Set(dd, depth.steps())));
        const auto seen = hn::IfThenElseZero(inside, step);
        auto* const to = reinterpret_cast<std::int32_t*>(row);  // at most 2^24 - 1
        const auto old = hn::LoadU(di, to);
        hn::StoreU(hn::Max(seen, old), di, to);
        return hn::Gt(seen, old);
    }
};

struct NoValues {
    NoValues(const FillJob&, const BinEntry&, TileBuffer&) {}
    HWY_INLINE void StartColumn(VI) {}
    HWY_INLINE void Write(int, int, VD, MI) {}
};

class ConstantValues {
  public:
    ConstantValues(const FillJob& job, const BinEntry& entry, TileBuffer& to) : to_(to) {
        const std::uint32_t triangle = job.batches[entry.batch].triangles[entry.index].triangle;
        constant_ = static_cast<std::int32_t>(job.input.constants[triangle]);
    }
    HWY_INLINE void StartColumn(VI) {}
    HWY_INLINE void Write(int x, int y, VD, MI mask) {
        const DI d;
        auto* to = reinterpret_cast<std::int32_t*>(to_.plane_row<std::uint32_t>(0, y)) + x;
        hn::StoreU(hn::IfThenElse(mask, hn::Set(d, constant_), hn::LoadU(d, to)), d, to);
    }

  private:
    TileBuffer& to_;
    std::int32_t constant_;
};

/// Codes that stay within their store all over the triangle: their planes' low 32 bits say all.
template <int kCount>
class InnerCodes {
  public:
    InnerCodes(const FillJob& job, const BinEntry& entry, TileBuffer& to)
        : to_(to),
          triangle_(job.batches[entry.batch].triangles[entry.index]),
          planes_(job.batches[entry.batch].code_planes.data() + entry.index * kCount) {}

    HWY_INLINE void StartColumn(VI from_ref) {
        for (int k = 0; k < kCount; ++k) {
            const auto dx = static_cast<std::int32_t>(planes_[k].dx);
            ramp_[k] = hn::Mul(hn::Set(DI(), dx), from_ref);
        }
    }
    HWY_INLINE void Write(int x, int y, VD, MI mask) {
        const DI d;
        const hn::RebindToUnsigned<DI> du;
        for (int k = 0; k < kCount; ++k) {
            const auto at_row = static_cast<std::int32_t>(planes_[k].at_ref +
                                                          planes_[k].dy * (y - triangle_.ref_y));
            const auto v = hn::BitCast(du, hn::Add(hn::Set(d, at_row), ramp_[k]));
            const auto code = hn::BitCast(d, hn::ShiftRight<kCodeFractionBits>(v));
            auto* to = reinterpret_cast<std::int32_t*>(to_.code_row(k, y)) + x;
            hn::StoreU(hn::IfThenElse(mask, code, hn::LoadU(d, to)), d, to);
        }
    }

  private:
    TileBuffer& to_;
    const SetupTriangle& triangle_;
    const CodePlane* planes_;
    VI ramp_[kCount];
};

/// Codes that may leave their store, or belong to a thin triangle.
template <int kCount>
class CodeValuesWhole {
  public:
    CodeValuesWhole(const FillJob& job, const BinEntry& entry, TileBuffer& to)
        : to_(to), triangle_(job.batches[entry.batch].triangles[entry.index]) {
        planes_ = job.batches[entry.batch].code_planes.data() + entry.index * kCount;
        const std::int64_t most = job.format.store == Store::u8 ? 0xff : 0xffff;
        const bool saturates = job.format.overflow == Overflow::saturate;
        low_ = saturates ? 0 : std::numeric_limits<std::int64_t>::min();
        high_ = saturates ? most : std::numeric_limits<std::int64_t>::max();
        mask_ = most;
    }
    HWY_INLINE void StartColumn(VI from_ref) {
        const DL dl;
        for (int k = 0; k < kCount; ++k)
            ramp_[k] = hn::Mul(hn::Set(dl, planes_[k].dx), hn::PromoteTo(dl, from_ref));
    }
    HWY_INLINE void Write(int x, int y, VD, MI mask) {
        const DI d;
        const DL dl;
        for (int k = 0; k < kCount; ++k) {
            const std::int64_t at_row = planes_[k].at_ref + planes_[k].dy * (y - triangle_.ref_y);
            auto v = hn::Add(hn::Set(dl, at_row), ramp_[k]);
            if (triangle_.is_thin) {
                v = hn::Min(hn::Max(v, hn::Set(dl, planes_[k].lowest)),
                            hn::Set(dl, planes_[k].highest));
            }
            const auto code = hn::ShiftRight<kCodeFractionBits>(v);
            const auto kept = hn::And(hn::Min(hn::Max(code, hn::Set(dl, low_)), hn::Set(dl, high_)),
                                      hn::Set(dl, mask_));
            const auto narrow = hn::TruncateTo(hn::RebindToUnsigned<DI>(),
                                               hn::BitCast(hn::RebindToUnsigned<DL>(), kept));
            auto* to = reinterpret_cast<std::int32_t*>(to_.code_row(k, y)) + x;
            hn::StoreU(hn::IfThenElse(mask, hn::BitCast(d, narrow), hn::LoadU(d, to)), d, to);
        }
    }

  private:
    TileBuffer& to_;
    const SetupTriangle& triangle_;
    const CodePlane* planes_;
    std::int64_t low_, high_, mask_;
    VL ramp_[kCount];
};

template <bool kPerspective>
class NumberValuesWhole {
  public:
    NumberValuesWhole(const FillJob& job, const BinEntry& entry, TileBuffer& to)
        : to_(to), triangle_(job.batches[entry.batch].triangles[entry.index]) {
        planes_ = job.batches[entry.batch].float_planes.data() + entry.index * kMaxPlanes;
    }
    HWY_INLINE void StartColumn(VI from_ref) {
        const DD dd;
        for (int k = 0; k < kMaxPlanes; ++k)
            ramp_[k] = hn::Mul(hn::Set(dd, planes_[k].plane.dx), hn::PromoteTo(dd, from_ref));
    }
    HWY_INLINE void Write(int x, int y, VD q, MI mask) {
        const DD dd;
        const DF df;
        const auto kept = hn::RebindMask(df, mask);
        for (int k = 0; k < kMaxPlanes; ++k) {
            const FloatPlane& p = planes_[k];
            const double at_row = p.plane.at_ref + p.plane.dy * (y - triangle_.ref_y);
            auto v = hn::Add(hn::Set(dd, at_row), ramp_[k]);
            if (kPerspective) v = hn::Div(v, q);
            auto number = hn::DemoteTo(df, v);
            if (kPerspective || triangle_.is_thin)
                number = hn::Min(hn::Max(number, hn::Set(df, p.lowest)), hn::Set(df, p.highest));
            float* to = to_.plane_row<float>(k, y) + x;
            hn::StoreU(hn::IfThenElse(kept, number, hn::LoadU(df, to)), df, to);
        }
    }

  private:
    TileBuffer& to_;
    const SetupTriangle& triangle_;
    const FloatPlane* planes_;
    VD ramp_[kMaxPlanes];
};

template <class Depth, class Values>
void FillSquare(const SetupTriangle& t,
                const Square& square,
                const Depth& depth,
                Values& values,
                TileBuffer& buffer) {
    const DI d;
    const DD dd;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto ramp = hn::Load(d, kRamp);
    const auto q_min = hn::Set(dd, t.q_min);
    const auto q_max = hn::Set(dd, t.q_max);
    const PixelRect& r = square.rect;
    // Column by column, so that what runs along a row is multiplied out once for all rows.
    for (int x = r.x0; x < r.x1; x += lanes) {
        const auto in_rect = hn::FirstN(d, static_cast<std::size_t>(r.x1 - x));
        const auto across = hn::Add(ramp, hn::Set(d, x - r.x0));
        VI edge[3], step[3];
        for (int k = 0; k < 3; ++k) {
            edge[k] = hn::Add(hn::Set(d, square.at[k]), hn::Mul(hn::Set(d, square.dx[k]), across));
            step[k] = hn::Set(d, square.dy[k]);
        }
        const auto from_ref = hn::Add(ramp, hn::Set(d, x - t.ref_x));
        const auto q_ramp = hn::Mul(hn::Set(dd, t.q.dx), hn::PromoteTo(dd, from_ref));
        values.StartColumn(from_ref);
        for (int y = r.y0; y < r.y1; ++y) {
            auto inside = in_rect;
            if (!square.is_inside) {
                const auto any = hn::Or3(edge[0], edge[1], edge[2]);
                inside = hn::And(inside, hn::Gt(any, hn::Set(d, -1)));
                for (int k = 0; k < 3; ++k)
                    edge[k] = hn::Add(edge[k], step[k]);
                if (hn::AllFalse(d, inside)) continue;
            }
            const auto q_row = hn::Set(dd, t.q.at_ref + t.q.dy * (y - t.ref_y));
            const auto q = hn::Min(hn::Max(hn::Add(q_row, q_ramp), q_min), q_max);
            auto* row = buffer.depth_row<typename Depth::Value>(y);
            values.Write(x, y, q, depth.Test(q, inside, row + x));
        }
    }
}

template <class Depth, class Values>
void FillRect(const FillJob& job,
              const BinEntry& entry,
              const PixelRect& rect,
              TileBuffer& buffer) {
    constexpr int kSquare_px = 16;
    const SetupTriangle& t = job.batches[entry.batch].triangles[entry.index];
    const PixelRect area{std::max(rect.x0, t.bounds.x0),
                         std::max(rect.y0, t.bounds.y0),
                         std::min(rect.x1, t.bounds.x1),
                         std::min(rect.y1, t.bounds.y1)};
    const Depth depth(job);
    Values values(job, entry, buffer);
    Square square;
    for (int y = area.y0; y < area.y1; y += kSquare_px) {
        for (int x = area.x0; x < area.x1; x += kSquare_px) {
            const PixelRect part{
                x, y, std::min(x + kSquare_px, area.x1), std::min(y + kSquare_px, area.y1)};
            if (MakeSquare(t, part, square)) FillSquare(t, square, depth, values, buffer);
        }
    }
}

template <class Values>
bool FillWith(const FillJob& job,
              const BinEntry& entry,
              const PixelRect& rect,
              TileBuffer& buffer) {
    if (job.format.depth == DepthFormat::q32) {
        FillRect<FloatDepthLanes, Values>(job, entry, rect, buffer);
    } else {
        FillRect<StepDepthLanes, Values>(job, entry, rect, buffer);
    }
    return true;
}

/// Whether no centre's code can leave the store: the corners' do not, by a margin for centres of
/// the snapped triangle that lie a little outside the true one.
bool AreInner(const FillJob& job, const BinEntry& entry) {
    const Batch& batch = job.batches[entry.batch];
    if (batch.triangles[entry.index].is_thin) return false;
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

bool FillWhole(const FillJob& job, const BinEntry& entry, const PixelRect& rect, TileBuffer& to) {
    const PassFormat& format = job.format;
    const bool is_affine = format.interpolation == Interpolation::affine;
    switch (format.store) {
        case Store::none:
            return FillWith<NoValues>(job, entry, rect, to);
        case Store::u32:
            return FillWith<ConstantValues>(job, entry, rect, to);
        case Store::f32:
            return is_affine ? FillWith<NumberValuesWhole<false>>(job, entry, rect, to)
                             : FillWith<NumberValuesWhole<true>>(job, entry, rect, to);
        default:
            break;
    }
    if (!is_affine) return false;
    if (AreInner(job, entry)) {
        return format.interpolants == 1 ? FillWith<InnerCodes<1>>(job, entry, rect, to)
                                        : FillWith<InnerCodes<2>>(job, entry, rect, to);
    }
    return format.interpolants == 1 ? FillWith<CodeValuesWhole<1>>(job, entry, rect, to)
                                    : FillWith<CodeValuesWhole<2>>(job, entry, rect, to);
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
    // Two steps over a square, and the value of an edge that crosses it, then fit 31 bits.
    constexpr std::int64_t kLongest = std::int64_t{1} << (22 + kSubpixelBits);
    for (const EdgeFunction& e : job.batches[entry.batch].triangles[entry.index].edges) {
        if (std::abs(e.dx) > kLongest || std::abs(e.dy) > kLongest) return false;
    }
    return HWY_DYNAMIC_DISPATCH(FillWhole)(job, entry, rect, buffer);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
