// Decaudin's two operators over rows, in vectors. Include after <hwy/highway.h>; compiled once per
// target, so without `#pragma once`.
#if defined(INK_EDGE_DECAUDIN_OPERATORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef INK_EDGE_DECAUDIN_OPERATORS_INL
#undef INK_EDGE_DECAUDIN_OPERATORS_INL
#else
#define INK_EDGE_DECAUDIN_OPERATORS_INL
#endif

#include <hwy/cache_control.h>
#include <array>

#include "edge/decaudin_filter.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kFloats = HWY_LANES(float);
/// Columns done at once, so that g stays in a near cache.
constexpr int kStrip_px = 512;
/// Rows done at once, so that a row is loaded once for the three that need it.
constexpr int kBlock = 4;
/// How far ahead of the filter memory is asked for, in floats.
constexpr int kAhead_px = 64;
/// One column more on either side, and where columns begin, so that column 0 is aligned.
constexpr int kPad_px = 16;
using StripRow = std::array<float, kStrip_px + 2 * kPad_px>;

/// Rows that lie `stride` floats apart, row 0 first.
template <class T>
struct RowsOf {
    T* first;
    std::ptrdiff_t stride;
};

/// A pixel and those left and right of it.
template <class V>
struct Three {
    V left;
    V mid;
    V right;
};

template <class D>
HWY_INLINE Three<hn::Vec<D>> load_three(D d, const float* at) {
    return {hn::LoadU(d, at - 1), hn::LoadU(d, at), hn::LoadU(d, at + 1)};
}

/// g with additions in the order of the plain formula.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V g_of(D d, const Three<V>& up, const Three<V>& mid, const Three<V>& down) {
    const auto off = [&](V v) HWY_ATTR { return hn::AbsDiff(v, mid.mid); };
    V corners = hn::Add(off(up.left), off(up.right));
    corners = hn::Add(hn::Add(corners, off(down.left)), off(down.right));
    V sides = hn::Add(off(up.mid), off(mid.left));
    sides = hn::Add(hn::Add(sides, off(mid.right)), off(down.mid));
    // Twice as a product: the machine's adders are what this waits for.
    const V sum = hn::Add(corners, hn::Mul(hn::Set(d, 2.0F), sides));
    return hn::Mul(sum, hn::Set(d, 0.125F));
}

/// Rows of g: `to[y]` from the rows y - 1, y and y + 1 of `from`.
template <int kRows>
HWY_INLINE void g_rows(RowsOf<const float> from, const std::array<float*, kRows>& to, int width) {
    cover<float, kFloats>(width, kFloats, [=](auto d, int x) HWY_ATTR {
        const float* at = from.first + x;
        auto up = load_three(d, at - from.stride);
        auto mid = load_three(d, at);
        for (std::size_t y = 0; y < kRows; ++y) {
            at += from.stride;
            const auto down = load_three(d, at);
            hwy::Prefetch(at + kAhead_px);
            hn::StoreU(g_of(d, up, mid, down), d, to[y] + x);
            up = mid;
            mid = down;
        }
    });
}

/// k as one product each: (d * scale)^2 * factor.
struct Sensitivity {
    float scale;
    float factor;

    explicit Sensitivity(const DecaudinK& k)
        : scale(k.place == KPlace::inside ? 1 / k.k : 1),
          factor(k.place == KPlace::inside ? 1 : 1 / k.k) {}
};

/// The least and the largest of some pixels.
template <class V>
struct Extremes {
    V low;
    V high;
};

template <class D>
HWY_INLINE Extremes<hn::Vec<D>> extremes_of(D d, const float* g) {
    const auto three = load_three(d, g);
    return {hn::Min(hn::Min(three.left, three.mid), three.right),
            hn::Max(hn::Max(three.left, three.mid), three.right)};
}

template <class V>
HWY_INLINE Extremes<V> join_extremes(const Extremes<V>& a, const Extremes<V>& b) {
    return {hn::Min(a.low, b.low), hn::Max(a.high, b.high)};
}

/// How a row of p meets what other channels left.
struct Replace {
    template <class V>
    HWY_INLINE V operator()(V, V p) const {
        return p;
    }
};
struct Larger {
    template <class V>
    HWY_INLINE V operator()(V joined, V p) const {
        return hn::Max(joined, p);
    }
};
struct Either {
    template <class V>
    HWY_INLINE V operator()(V joined, V p) const {
        return hn::Add(joined, hn::Sub(p, hn::Mul(joined, p)));
    }
};
struct Squares {
    template <class V>
    HWY_INLINE V operator()(V joined, V p) const {
        return hn::Add(joined, hn::Mul(p, p));
    }
};

/// The first channel meets 0, and not what the row holds.
template <class Join>
struct First {
    template <class V>
    HWY_INLINE V operator()(V, V p) const {
        return Join()(hn::Xor(p, p), p);
    }
};

/// Rows of p, joined with what `to` holds: row y from the rows y, y + 1 and y + 2 of `g`.
template <int kRows, class Join>
HWY_INLINE void p_rows(const std::array<const float*, kRows + 2>& g,
                       const DecaudinK& given_k,
                       RowsOf<float> to,
                       int width,
                       Join join) {
    const Sensitivity k(given_k);
    cover_once<float, kFloats>(width, [=](auto d, int x) HWY_ATTR {
        auto up = extremes_of(d, g[0] + x);
        auto mid = extremes_of(d, g[1] + x);
        float* out = to.first + x;
        for (std::size_t y = 0; y < kRows; ++y) {
            const auto down = extremes_of(d, g[y + 2] + x);
            const auto all = join_extremes(join_extremes(up, mid), down);
            const auto spread = hn::Mul(hn::Sub(all.high, all.low), hn::Set(d, k.scale));
            const auto square = hn::Mul(hn::Mul(spread, spread), hn::Set(d, k.factor));
            const auto p = hn::Min(square, hn::Set(d, 1.0F));
            hn::StoreU(join(hn::LoadU(d, out), p), d, out);
            up = mid;
            mid = down;
            out += to.stride;
        }
    });
}

/// Makes edge responses of a row of joined p.
HWY_INLINE void write_row(const float* joined, DecaudinJoin join, std::uint8_t* out, int width) {
    cover<float, kFloats>(width, kFloats, [=](auto d, int x) HWY_ATTR {
        const hn::Rebind<std::int32_t, decltype(d)> di;
        const hn::Rebind<std::uint8_t, decltype(d)> du8;
        auto p = hn::LoadU(d, joined + x);
        if (join == DecaudinJoin::length) p = hn::Sqrt(p);
        p = hn::Mul(hn::Min(p, hn::Set(d, 1.0F)), hn::Set(d, 255.0F));
        const auto edge_response = hn::ConvertTo(di, hn::Add(p, hn::Set(d, 0.5F)));
        hn::StoreU(hn::DemoteTo(du8, edge_response), du8, out + x);
    });
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
