#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/binomial_blur_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cassert>

#include "edge/binomial_blur.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"
#include "edge/wide_lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A neighbour as it counts in the sum: as it is, or by its shortest way round from the middle one.
template <bool kWraps, class D>
struct Neighbour {
    D d;
    hn::Vec<D> mid;
    int sign_shift;

    template <class T>
    HWY_INLINE hn::Vec<D> operator()(const T* at) const {
        const auto value = load_wide(d, at);
        if constexpr (!kWraps) return value;
        const auto way = hn::ShiftLeftSame(hn::Sub(value, mid), sign_shift);
        return hn::ShiftRightSame(way, sign_shift);
    }
};

template <bool kWraps, class D, class T>
HWY_INLINE hn::Vec<D> blurred(D d, const Stencil<T>& at, int code_bits) {
    using Lane = Wide<T>;
    const auto mid = load_wide(d, at.mid);
    const int lane_bits = 8 * static_cast<int>(sizeof(Lane));
    const Neighbour<kWraps, D> of{d, mid, lane_bits - code_bits};
    const auto corners =
        hn::Add(hn::Add(of(at.up - 1), of(at.up + 1)), hn::Add(of(at.down - 1), of(at.down + 1)));
    const auto sides =
        hn::Add(hn::Add(of(at.up), of(at.down)), hn::Add(of(at.mid - 1), of(at.mid + 1)));
    const auto ring = hn::Add(hn::Add(corners, hn::Add(sides, sides)), hn::Set(d, Lane{8}));
    if constexpr (kWraps) {
        const auto mask = hn::Set(d, static_cast<Lane>((std::int64_t{1} << code_bits) - 1));
        return hn::And(hn::Add(mid, hn::ShiftRight<4>(ring)), mask);
    } else {
        return hn::ShiftRight<4>(hn::Add(ring, hn::ShiftLeft<2>(mid)));
    }
}

template <bool kWraps, class T>
void blur_rows(const core::ImageView<const T>& codes,
               int code_bits,
               const core::ImageView<T>& out) {
    constexpr int kLanes = HWY_LANES(Wide<T>);
    for (int y = 0; y < out.height_px; ++y) {
        const T* mid = codes.row(y);
        const Stencil<T> row{mid - codes.stride, mid, mid + codes.stride};
        T* to = out.row(y);
        cover<Wide<T>, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const Stencil<T> at{row.up + x, row.mid + x, row.down + x};
            store_wide(d, blurred<kWraps>(d, at, code_bits), to + x);
        });
    }
}

template <class T>
void blur(const core::ImageView<const T>& codes, int code_bits, const core::ImageView<T>& out) {
    if (code_bits == 0) return blur_rows<false>(codes, code_bits, out);
    blur_rows<true>(codes, code_bits, out);
}

void blur_u8(const core::ImageView<const std::uint8_t>& codes,
             int code_bits,
             const core::ImageView<std::uint8_t>& out) {
    blur(codes, code_bits, out);
}
void blur_u16(const core::ImageView<const std::uint16_t>& codes,
              int code_bits,
              const core::ImageView<std::uint16_t>& out) {
    blur(codes, code_bits, out);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(blur_u8);
HWY_EXPORT(blur_u16);

}  // namespace

void binomial_blur(const core::ImageView<const std::uint8_t>& codes,
                   const core::ImageView<std::uint8_t>& out,
                   int code_bits,
                   int threads) {
    assert(code_bits >= 0 && code_bits <= 8);
    const auto kernel = HWY_DYNAMIC_DISPATCH(blur_u8);
    filter_row_bands(codes, out, threads, [&](const auto& from, const auto& to) {
        kernel(from, code_bits, to);
    });
}

void binomial_blur(const core::ImageView<const std::uint16_t>& codes,
                   const core::ImageView<std::uint16_t>& out,
                   int code_bits,
                   int threads) {
    assert(code_bits >= 0 && code_bits <= 16);
    const auto kernel = HWY_DYNAMIC_DISPATCH(blur_u16);
    filter_row_bands(codes, out, threads, [&](const auto& from, const auto& to) {
        kernel(from, code_bits, to);
    });
}

}  // namespace ink::edge
#endif
