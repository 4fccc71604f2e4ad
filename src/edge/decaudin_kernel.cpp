#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/decaudin_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <cassert>

#include "edge/decaudin_filter.h"
#include "edge/decaudin_operators.inl"
#include "edge/row_bands.h"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

void row_p(const std::array<const float*, 3>& g, float* p, int width, const DecaudinK& k) {
    p_rows<1>(g, k, {p, 0}, width, Replace());
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
namespace {

HWY_EXPORT(row_p);
HWY_EXPORT(all_channels);

}  // namespace

void decaudin_p_row(const float* g_up,
                    const float* g_mid,
                    const float* g_down,
                    float* p,
                    int width,
                    const DecaudinK& k) {
    assert(k.k > 0);
    HWY_DYNAMIC_DISPATCH(row_p)({g_up, g_mid, g_down}, p, width, k);
}

void decaudin(std::span<const DecaudinChannel> channels,
              DecaudinJoin join,
              const core::ImageView<std::uint8_t>& out,
              int threads) {
    assert(!channels.empty() && channels.size() <= kMaxDecaudinChannels);
    for_row_bands(out.height_px, threads, [&](int y0, int y1) {
        std::array<DecaudinChannel, kMaxDecaudinChannels> band;
        std::copy(channels.begin(), channels.end(), band.begin());
        for (DecaudinChannel& channel : band)
            channel.origin += y0 * channel.stride;
        HWY_DYNAMIC_DISPATCH(all_channels)
        ({band.data(), channels.size()}, join, {out.row(y0), out.width_px, y1 - y0, out.stride});
    });
}

}  // namespace ink::edge
#endif
