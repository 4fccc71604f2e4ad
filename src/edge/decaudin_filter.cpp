#include "edge/decaudin_filter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace ink::edge {
namespace {

constexpr int kStretch = 64;

// By value: std::min and std::max hand on references, which keeps the compiler from vectorising.
inline float lower(float a, float b) {
    return b < a ? b : a;
}
inline float higher(float a, float b) {
    return a < b ? b : a;
}

}  // namespace

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
    // (d / k)^2 and d^2 / k as one product each: (d * scale)^2 * factor.
    const float scale = k.place == KPlace::inside ? 1 / k.k : 1;
    const float factor = k.place == KPlace::inside ? 1 : 1 / k.k;
    // Columns first, then rows, a stretch at a time: half the comparisons, nothing allocated.
    std::array<float, kStretch + 2> low;
    std::array<float, kStretch + 2> high;
    for (int x0 = 0; x0 < width; x0 += kStretch) {
        const int count = std::min(kStretch, width - x0);
        for (int i = 0; i < count + 2; ++i) {
            const int x = x0 + i - 1;
            low[i] = lower(lower(g_up[x], g_mid[x]), g_down[x]);
            high[i] = higher(higher(g_up[x], g_mid[x]), g_down[x]);
        }
        float* __restrict out = p + x0;
        for (int i = 0; i < count; ++i) {
            const float g_min = lower(lower(low[i], low[i + 1]), low[i + 2]);
            const float g_max = higher(higher(high[i], high[i + 1]), high[i + 2]);
            const float d = (g_max - g_min) * scale;
            out[i] = lower(d * d * factor, 1.0F);
        }
    }
}

}  // namespace ink::edge
