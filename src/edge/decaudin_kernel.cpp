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
/// Columns done at once: what stays in the nearest cache with room for all rows of a strip.
constexpr int kStrip_px = 2048;
/// Rows between the one that is filtered and the one that is fetched.
constexpr int kAhead_px = 4;
/// One column more on either side, and where columns begin, so that column 0 is aligned.
constexpr int kPad_px = 16;
using StripRow = std::array<float, kStrip_px + 2 * kPad_px>;

/// One row of g, additions in the order of the plain formula.
HWY_INLINE void g_row(const DecaudinG& given) {
    const DecaudinG row = given;
    cover<float, kFloats>(row.width, kFloats, [=](auto d, int x) HWY_ATTR {
        const auto c = hn::LoadU(d, row.mid + x);
        const auto off = [=](const float* from, int dx)
                             HWY_ATTR { return hn::AbsDiff(hn::LoadU(d, from + x + dx), c); };
        auto corners = hn::Add(off(row.up, -1), off(row.up, 1));
        corners = hn::Add(hn::Add(corners, off(row.down, -1)), off(row.down, 1));
        auto sides = hn::Add(off(row.up, 0), off(row.mid, -1));
        sides = hn::Add(hn::Add(sides, off(row.mid, 1)), off(row.down, 0));
        const auto sum = hn::Add(corners, hn::Mul(hn::Set(d, 2.0F), sides));
        hn::StoreU(hn::Mul(sum, hn::Set(d, 0.125F)), d, row.g + x);
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

/// Three rows of g and the extremes of their columns, from column -1 to `width`.
struct Columns {
    StripRow low;
    StripRow high;
};

HWY_INLINE void find_extremes(const DecaudinP& given, Columns& columns) {
    const DecaudinP row = given;
    float* low = columns.low.data() + kPad_px - 1;
    float* high = columns.high.data() + kPad_px - 1;
    cover<float, kFloats>(row.width + 2, kFloats, [=](auto d, int x) HWY_ATTR {
        const auto up = hn::LoadU(d, row.g_up + x - 1);
        const auto mid = hn::LoadU(d, row.g_mid + x - 1);
        const auto down = hn::LoadU(d, row.g_down + x - 1);
        hn::StoreU(hn::Min(hn::Min(up, mid), down), d, low + x);
        hn::StoreU(hn::Max(hn::Max(up, mid), down), d, high + x);
    });
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

template <class Join>
HWY_INLINE void p_row(const DecaudinP& given, Join join) {
    Columns columns;
    const DecaudinP row = given;
    find_extremes(row, columns);
    const float* low = columns.low.data() + kPad_px;
    const float* high = columns.high.data() + kPad_px;
    const Sensitivity k(row.k);
    cover_once<float, kFloats>(row.width, [=](auto d, int x) HWY_ATTR {
        const auto g_min = hn::Min(hn::Min(hn::LoadU(d, low + x - 1), hn::LoadU(d, low + x)),
                                   hn::LoadU(d, low + x + 1));
        const auto g_max = hn::Max(hn::Max(hn::LoadU(d, high + x - 1), hn::LoadU(d, high + x)),
                                   hn::LoadU(d, high + x + 1));
        const auto spread = hn::Mul(hn::Sub(g_max, g_min), hn::Set(d, k.scale));
        const auto square = hn::Mul(hn::Mul(spread, spread), hn::Set(d, k.factor));
        const auto p = hn::Min(square, hn::Set(d, 1.0F));
        hn::StoreU(join(hn::LoadU(d, row.p + x), p), d, row.p + x);
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

/// g of the last three rows of one channel.
struct Ring {
    std::array<StripRow, 3> rows;

    float* row(int y) { return rows[static_cast<std::size_t>(y + 3) % 3].data() + kPad_px; }
};

HWY_INLINE void prefetch_row(const float* row, int width) {
    constexpr int kLine = 64 / sizeof(float);
    for (int x = 0; x < width; x += kLine)
        hwy::Prefetch(row + x);
}

/// A strip at most kStrip_px wide from the top down, all channels of a row together, so that each
/// number is read from memory once and only strengths are written.
template <class Join>
void strip(std::span<const DecaudinChannel> channels,
           DecaudinJoin join,
           Join joining,
           const core::ImageView<std::uint8_t>& out) {
    std::array<Ring, kMaxDecaudinChannels> g;
    StripRow joined;
    const int width = out.width_px;
    for (int y = -1; y <= out.height_px; ++y) {
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const DecaudinChannel& channel = channels[i];
            const float* mid = channel.origin + y * channel.stride - 1;
            // Rows lie pages apart, where the machine does not look ahead by itself.
            if (false && y + kAhead_px <= out.height_px) {
                prefetch_row(mid + kAhead_px * channel.stride, width + 2);
            }
            g_row({mid - channel.stride, mid, mid + channel.stride, g[i].row(y) - 1, width + 2});
            if (y < 1) continue;
            const DecaudinP row{
                g[i].row(y - 2), g[i].row(y - 1), g[i].row(y), joined.data(), width, channel.k};
            if (i == 0) {
                p_row(row, First<Join>());
            } else {
                p_row(row, joining);
            }
        }
        if (y >= 1) write_row(joined.data(), join, out.row(y - 1), width);
    }
}

template <class Join>
void strips(std::span<const DecaudinChannel> given,
            DecaudinJoin join,
            Join joining,
            const core::ImageView<std::uint8_t>& out) {
    std::array<DecaudinChannel, kMaxDecaudinChannels> channels;
    std::copy(given.begin(), given.end(), channels.begin());
    for (int x = 0; x < out.width_px; x += kStrip_px) {
        const int width = std::min(kStrip_px, out.width_px - x);
        strip({channels.data(), given.size()},
              join,
              joining,
              {out.data + x, width, out.height_px, out.stride});
        for (DecaudinChannel& channel : channels)
            channel.origin += kStrip_px;
    }
}

void all_g(const DecaudinG& row) {
    g_row(row);
}

void all_p(const DecaudinP& row) {
    DecaudinP part = row;
    for (int x = 0; x < row.width; x += kStrip_px) {
        part.width = std::min(kStrip_px, row.width - x);
        part.g_up = row.g_up + x;
        part.g_mid = row.g_mid + x;
        part.g_down = row.g_down + x;
        part.p = row.p + x;
        p_row(part, Replace());
    }
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
