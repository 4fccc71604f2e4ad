#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/decaudin_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/cache_control.h>
#include <array>

#include "edge/decaudin_kernel.h"
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
    return hn::Mul(hn::Add(corners, hn::Add(sides, sides)), hn::Set(d, 0.125F));
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

/// Makes strengths of a row of joined p.
HWY_INLINE void write_row(const float* joined, DecaudinJoin join, std::uint8_t* out, int width) {
    cover<float, kFloats>(width, kFloats, [=](auto d, int x) HWY_ATTR {
        const hn::Rebind<std::int32_t, decltype(d)> di;
        const hn::Rebind<std::uint8_t, decltype(d)> du8;
        auto p = hn::LoadU(d, joined + x);
        if (join == DecaudinJoin::length) p = hn::Sqrt(p);
        p = hn::Mul(hn::Min(p, hn::Set(d, 1.0F)), hn::Set(d, 255.0F));
        const auto strength = hn::ConvertTo(di, hn::Add(p, hn::Set(d, 0.5F)));
        hn::StoreU(hn::DemoteTo(du8, strength), du8, out + x);
    });
}

/// g of the last rows of one channel: a block of them, and the two rows before it.
struct Ring {
    static constexpr int kRows = 8;
    std::array<StripRow, kRows> rows;

    float* row(int y) { return rows[static_cast<std::size_t>(y + kRows) % kRows].data() + kPad_px; }
};

/// The p of rows y0 .. y0 + kRows - 1, and the g that they still lack.
template <int kRows, class Join>
HWY_INLINE void channel_rows(const DecaudinChannel& channel,
                             Ring& ring,
                             int y0,
                             const core::ImageView<float>& joined,
                             Join join) {
    std::array<float*, kRows> fresh;
    for (int i = 0; i < kRows; ++i)
        fresh[static_cast<std::size_t>(i)] = ring.row(y0 + 1 + i) - 1;
    const float* from = channel.origin + (y0 + 1) * channel.stride - 1;
    g_rows<kRows>({from, channel.stride}, fresh, joined.width_px + 2);
    std::array<const float*, kRows + 2> g;
    for (int i = 0; i < kRows + 2; ++i)
        g[static_cast<std::size_t>(i)] = ring.row(y0 - 1 + i);
    p_rows<kRows>(g, channel.k, {joined.data, joined.stride}, joined.width_px, join);
}

/// A strip at most kStrip_px wide, from the top down.
class Strip {
  public:
    Strip(std::span<const DecaudinChannel> channels,
          DecaudinJoin join,
          const core::ImageView<std::uint8_t>& out)
        : channels_(channels), join_(join), out_(out) {}

    template <class Join>
    void run(Join joining) {
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            const DecaudinChannel& channel = channels_[i];
            const float* from = channel.origin - channel.stride - 1;
            g_rows<2>(
                {from, channel.stride}, {g_[i].row(-1) - 1, g_[i].row(0) - 1}, out_.width_px + 2);
        }
        int y = 0;
        for (; y + kBlock <= out_.height_px; y += kBlock)
            rows<kBlock>(y, joining);
        for (; y < out_.height_px; ++y)
            rows<1>(y, joining);
    }

  private:
    template <int kRows, class Join>
    HWY_INLINE void rows(int y0, Join joining) {
        const core::ImageView<float> joined{joined_[0].data(),
                                            out_.width_px,
                                            kRows,
                                            static_cast<std::ptrdiff_t>(joined_[0].size())};
        channel_rows<kRows>(channels_[0], g_[0], y0, joined, First<Join>());
        for (std::size_t i = 1; i < channels_.size(); ++i)
            channel_rows<kRows>(channels_[i], g_[i], y0, joined, joining);
        for (int y = 0; y < kRows; ++y)
            write_row(joined.row(y), join_, out_.row(y0 + y), out_.width_px);
    }

    std::span<const DecaudinChannel> channels_;
    DecaudinJoin join_;
    core::ImageView<std::uint8_t> out_;
    std::array<Ring, kMaxDecaudinChannels> g_;
    std::array<StripRow, kBlock> joined_;
};

template <class Join>
void strips(std::span<const DecaudinChannel> given,
            DecaudinJoin join,
            Join joining,
            const core::ImageView<std::uint8_t>& out) {
    std::array<DecaudinChannel, kMaxDecaudinChannels> channels;
    std::copy(given.begin(), given.end(), channels.begin());
    for (int x = 0; x < out.width_px; x += kStrip_px) {
        const int width = std::min(kStrip_px, out.width_px - x);
        Strip strip({channels.data(), given.size()},
                    join,
                    {out.data + x, width, out.height_px, out.stride});
        strip.run(joining);
        for (DecaudinChannel& channel : channels)
            channel.origin += kStrip_px;
    }
}

void all_g(const DecaudinG& row) {
    cover<float, kFloats>(row.width, kFloats, [=](auto d, int x) HWY_ATTR {
        const auto up = load_three(d, row.up + x);
        const auto mid = load_three(d, row.mid + x);
        hn::StoreU(g_of(d, up, mid, load_three(d, row.down + x)), d, row.g + x);
    });
}

void all_p(const DecaudinP& row) {
    p_rows<1>({row.g_up, row.g_mid, row.g_down}, row.k, {row.p, 0}, row.width, Replace());
}

void all_channels(std::span<const DecaudinChannel> channels,
                  DecaudinJoin join,
                  const core::ImageView<std::uint8_t>& out) {
    switch (join) {
        case DecaudinJoin::max:
            return strips(channels, join, Larger(), out);
        case DecaudinJoin::either:
            return strips(channels, join, Either(), out);
        case DecaudinJoin::length:
            return strips(channels, join, Squares(), out);
    }
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

HWY_EXPORT(all_g);
HWY_EXPORT(all_p);
HWY_EXPORT(all_channels);

void decaudin_g(const DecaudinG& row) {
    HWY_DYNAMIC_DISPATCH(all_g)(row);
}

void decaudin_p(const DecaudinP& row) {
    HWY_DYNAMIC_DISPATCH(all_p)(row);
}

void decaudin_picture(std::span<const DecaudinChannel> channels,
                      DecaudinJoin join,
                      const core::ImageView<std::uint8_t>& out) {
    HWY_DYNAMIC_DISPATCH(all_channels)(channels, join, out);
}

}  // namespace ink::edge
#endif
