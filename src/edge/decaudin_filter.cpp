#include "edge/decaudin_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ink::edge {

void decaudin_g_row(const float* up, const float* mid, const float* down, float* g, int width) {
    float* __restrict out = g;
    for (int x = 0; x < width; ++x) {
        const float c = mid[x];
        const float corners = std::abs(up[x - 1] - c) + std::abs(up[x + 1] - c) +
                              std::abs(down[x - 1] - c) + std::abs(down[x + 1] - c);
        const float sides = std::abs(up[x] - c) + std::abs(mid[x - 1] - c) +
                            std::abs(mid[x + 1] - c) + std::abs(down[x] - c);
        out[x] = (corners + 2 * sides) * 0.125F;
    }
}

void decaudin_p_row(const float* g_up,
                    const float* g_mid,
                    const float* g_down,
                    float* p,
                    int width,
                    const DecaudinK& k) {
    assert(k.k > 0);
    // ((d / k)^2 and d^2 / k as one product each: (d * scale)^2 * factor.
    const float scale = k.place == KPlace::inside ? 1 / k.k : 1;
    const float factor = k.place == KPlace::inside ? 1 : 1 / k.k;
    float* __restrict out = p;
    const auto low = [&](int x) { return std::min(std::min(g_up[x], g_mid[x]), g_down[x]); };
    const auto high = [&](int x) { return std::max(std::max(g_up[x], g_mid[x]), g_down[x]); };
    for (int x = 0; x < width; ++x) {
        const float g_min = std::min(std::min(low(x - 1), low(x)), low(x + 1));
        const float g_max = std::max(std::max(high(x - 1), high(x)), high(x + 1));
        const float d = (g_max - g_min) * scale;
        out[x] = std::min(d * d * factor, 1.0F);
    }
}

}  // namespace ink::edge
