// The Laplacian without widening: bytes stay bytes, and 64 of them fit a register.
//
// Edge responses need |L| only up to 255, or (clipped) only |L| / 4, and that is the difference of
// the middle pixel and a quarter of its neighbours' sum s, rounded the right way. Rounding averages
// give s / 4 but for the lost bits e of each halving:
//     a = (u + d + e1) / 2, b = (l + r + e2) / 2, c = (a + b + e3) / 2  =>  s = 4 c - 2 e3 - e1 -
//     e2
// so ceil(s / 4) = c - (e1 & e2 & e3) and floor(s / 4) = c - (e1 | e2 | e3), exactly.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/laplacian_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/laplacian_plan.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pixel and its four neighbours.
template <class V>
struct Cross {
    V up;
    V mid;
    V down;
    V left;
    V right;
};

/// `v`, which the compiler must take as it is. GCC otherwise loads one vector twice, for its use as
/// bytes and as bits, and moves masks to where they cost an instruction more.
template <class V>
HWY_INLINE V as_is(V v) {
#if HWY_COMPILER_GCC_ACTUAL && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    asm("" : "+v"(v.raw));
#endif
    return v;
}

/// 1 where a + b is odd.
template <class V>
HWY_INLINE V odd(V a, V b, V one) {
    return as_is(hn::And(hn::Xor(a, b), one));
}

/// A quarter of the neighbours' sum.
template <class V>
struct Quarter {
    V ceil;
    V floor;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Quarter<V> quarter_sum(D d, const Cross<V>& p) {
    const V one = hn::Set(d, 1);
    const V a = hn::AverageRound(p.up, p.down);
    const V b = hn::AverageRound(p.left, p.right);
    const V c = hn::AverageRound(a, b);
    const V e1 = odd(p.up, p.down, one);
    const V e2 = odd(p.left, p.right, one);
    const V e3 = odd(a, b, one);
    return {hn::Sub(c, hn::And(e1, hn::And(e2, e3))), hn::Sub(c, hn::Or(e1, hn::Or(e2, e3)))};
}

/// |L| / 4 rounded down, or max(L, 0) / 4.
template <Reading kReading, class V>
HWY_INLINE V quarter_laplacian(const Quarter<V>& sum, V mid) {
    const V above = hn::SaturatedSub(mid, sum.ceil);
    if constexpr (kReading == Reading::positive) return above;
    return hn::Or(above, hn::SaturatedSub(sum.floor, mid));
}

/// The low bits of |L| or max(L, 0) that `mask` has.
template <Reading kReading, class D, class V = hn::Vec<D>>
HWY_INLINE V low_bits(D d, const Cross<V>& p, const Quarter<V>& quarter, V mask) {
    const V zero = hn::Zero(d);
    const V sum = hn::Add(hn::Add(p.up, p.down), hn::Add(p.left, p.right));
    const V other = kReading == Reading::positive ? zero : sum;
    const auto is_positive = hn::Eq(hn::SaturatedSub(quarter.ceil, p.mid), zero);
    return hn::And(hn::IfThenElse(is_positive, hn::Sub(zero, sum), other), mask);
}

/// L modulo the size of a lane.
template <class V>
HWY_INLINE V wrapped_laplacian(const Cross<V>& p) {
    const V twice = hn::Add(p.mid, p.mid);
    const V sum = hn::Add(hn::Add(p.up, p.down), hn::Add(p.left, p.right));
    return hn::Sub(hn::Add(twice, twice), sum);
}

template <Reading kReading, class D, class V = hn::Vec<D>>
HWY_INLINE V read_wrapped(D d, const Cross<V>& p, int code_shift) {
    const V laplacian = wrapped_laplacian(p);
    if constexpr (kReading == Reading::literal) return laplacian;
    const hn::RebindToSigned<D> di;
    const auto value = hn::BitCast(di, hn::ShiftLeftSame(laplacian, code_shift));
    const auto read =
        kReading == Reading::wrapped_absolute ? hn::Abs(value) : hn::Max(value, hn::Zero(di));
    return hn::ShiftRightSame(hn::BitCast(d, read), code_shift);
}

template <class V>
HWY_INLINE V doubled(V v, int times) {
    for (int i = 0; i < times; ++i)
        v = hn::SaturatedAdd(v, v);
    return v;
}

/// What `store` can cut to a byte: 16 bits that are not negative when read with a sign.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V storable(D d, V v) {
    if constexpr (sizeof(hn::TFromD<D>) == 1) return v;
    return hn::Min(v, hn::Set(d, 255));
}

/// Edge responses in lanes as wide as the codes, those of 16 bits up to 256.
template <Reading kReading, bool kIsQuadruple, class D, class V = hn::Vec<D>>
HWY_INLINE V edge_responses(D d, const Cross<V>& p, const LaplacianPlan& plan) {
    using T = hn::TFromD<D>;
    const V keep = hn::Set(d, static_cast<T>(plan.keep));
    if constexpr (kReading == Reading::literal) {
        const V v = hn::And(read_wrapped<kReading>(d, p, 0), keep);
        const V bits = hn::ShiftLeftSame(hn::ShiftRightSame(v, plan.right), plan.left);
        return hn::And(bits, hn::Set(d, 255));
    } else if constexpr (kReading == Reading::wrapped_absolute ||
                         kReading == Reading::wrapped_positive) {
        const V v = hn::And(read_wrapped<kReading>(d, p, plan.code_shift), keep);
        return storable(d, doubled(hn::ShiftRightSame(v, plan.right), plan.left));
    } else if constexpr (kIsQuadruple) {
        const V v = quarter_laplacian<kReading>(quarter_sum(d, p), p.mid);
        if constexpr (sizeof(T) == 1) return doubled(v, 2);
        return hn::ShiftLeft<2>(hn::Min(v, hn::Set(d, 64)));
    } else {
        const Quarter<V> sum = quarter_sum(d, p);
        V v = doubled(hn::And(quarter_laplacian<kReading>(sum, p.mid), keep), plan.double_first);
        if (plan.low != 0) {
            const V low = low_bits<kReading>(d, p, sum, hn::Set(d, static_cast<T>(plan.low)));
            v = hn::SaturatedAdd(v, hn::ShiftRightSame(low, plan.low_right));
        }
        return storable(d, doubled(hn::ShiftRightSame(v, plan.right), plan.left));
    }
}

template <class D>
HWY_INLINE void store(D d, hn::Vec<D> edge_responses, std::uint8_t* out) {
    if constexpr (sizeof(hn::TFromD<D>) == 1) {
        hn::StoreU(edge_responses, d, out);
    } else {
        const hn::Rebind<std::uint8_t, D> du8;
        const hn::RebindToSigned<D> di;
        hn::StoreU(hn::DemoteTo(du8, hn::BitCast(di, edge_responses)), du8, out);
    }
}

/// All rows at once, from the top down in each column of vectors, so that a row is loaded once for
/// the three that need it.
template <Reading kReading, bool kIsQuadruple, class T>
void filter_block(const core::ImageView<const T>& given_codes,
                  const core::ImageView<std::uint8_t>& given_out,
                  const LaplacianPlan& given_plan) {
    // Copies, which bytes stored through a pointer cannot change.
    const core::ImageView<const T> codes = given_codes;
    const core::ImageView<std::uint8_t> out = given_out;
    const LaplacianPlan plan = given_plan;
    const int first_step = aligning_step<T>(out.data, out.width_px, out.stride);
    constexpr int kLanes = HWY_LANES(T);
    cover<T, kLanes>(out.width_px, first_step, [=](auto d, int x) HWY_ATTR {
        const T* at_mid = codes.data + x;
        const T* at_down = at_mid + codes.stride;
        std::uint8_t* to = out.data + x;
        auto up = hn::LoadU(d, at_mid - codes.stride);
        auto mid = hn::LoadU(d, at_mid);
        for (int y = 0; y < out.height_px; ++y) {
            const auto down = hn::LoadU(d, at_down);
            const auto left = as_is(hn::LoadU(d, at_mid - 1));
            const auto right = as_is(hn::LoadU(d, at_mid + 1));
            const Cross<decltype(up)> cross{up, mid, down, left, right};
            store(d, edge_responses<kReading, kIsQuadruple>(d, cross, plan), to);
            up = mid;
            mid = down;
            at_mid += codes.stride;
            at_down += codes.stride;
            to += out.stride;
        }
    });
}

/// Wide images by four rows, so that memory is walked through along its lines; tiles, which are
/// in the cache, as a whole.
template <Reading kReading, bool kIsQuadruple, class T>
void filter_as(const core::ImageView<const T>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianPlan& plan) {
    constexpr int kTile_px = 128;
    const int block = out.width_px <= kTile_px ? out.height_px : 4;
    for (int y = 0; y < out.height_px; y += block) {
        const int height_px = std::min(block, out.height_px - y);
        filter_block<kReading, kIsQuadruple, T>(
            {codes.row(y), out.width_px, height_px, codes.stride},
            {out.row(y), out.width_px, height_px, out.stride},
            plan);
    }
}

template <class T>
void filter(const core::ImageView<const T>& codes,
            const core::ImageView<std::uint8_t>& out,
            const LaplacianPlan& plan) {
    switch (plan.reading) {
        case Reading::absolute:
            return plan.is_quadruple() ? filter_as<Reading::absolute, true>(codes, out, plan)
                                       : filter_as<Reading::absolute, false>(codes, out, plan);
        case Reading::positive:
            return plan.is_quadruple() ? filter_as<Reading::positive, true>(codes, out, plan)
                                       : filter_as<Reading::positive, false>(codes, out, plan);
        case Reading::wrapped_absolute:
            return filter_as<Reading::wrapped_absolute, false>(codes, out, plan);
        case Reading::wrapped_positive:
            return filter_as<Reading::wrapped_positive, false>(codes, out, plan);
        case Reading::literal:
            return filter_as<Reading::literal, false>(codes, out, plan);
    }
}

void filter_u8(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianPlan& plan) {
    filter(codes, out, plan);
}
void filter_u16(const core::ImageView<const std::uint16_t>& codes,
                const core::ImageView<std::uint8_t>& out,
                const LaplacianPlan& plan) {
    filter(codes, out, plan);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(filter_u8);
HWY_EXPORT(filter_u16);

}  // namespace

void laplacian(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads) {
    const LaplacianPlan plan(response, 8);
    const auto kernel = HWY_DYNAMIC_DISPATCH(filter_u8);
    filter_row_bands(
        codes, out, threads, [&](const auto& from, const auto& to) { kernel(from, to, plan); });
}

void laplacian(const core::ImageView<const std::uint16_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               const LaplacianResponse& response,
               int threads) {
    const LaplacianPlan plan(response, 16);
    const auto kernel = HWY_DYNAMIC_DISPATCH(filter_u16);
    filter_row_bands(
        codes, out, threads, [&](const auto& from, const auto& to) { kernel(from, to, plan); });
}

}  // namespace ink::edge
#endif
