#include "edge/decaudin_filter.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "edge/decaudin_kernel.h"
#include "edge/row_bands.h"

namespace ink::edge {

void decaudin_g_row(const float* up, const float* mid, const float* down, float* g, int width) {
    decaudin_g({up, mid, down, g, width});
}

void decaudin_p_row(const float* g_up,
                    const float* g_mid,
                    const float* g_down,
                    float* p,
                    int width,
                    const DecaudinK& k) {
    assert(k.k > 0);
    decaudin_p({g_up, g_mid, g_down, p, width, k});
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
        decaudin_image(
            {band.data(), channels.size()}, join, {out.row(y0), out.width_px, y1 - y0, out.stride});
    });
}

}  // namespace ink::edge
