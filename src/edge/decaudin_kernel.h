#pragma once

#include "edge/decaudin_filter.h"

namespace ink::edge {

/// decaudin_g_row, decaudin_p_row and decaudin of decaudin_filter.h on the best SIMD target,
/// without their checks and threads.
struct DecaudinG {
    const float* up;
    const float* mid;
    const float* down;
    float* g;
    int width;
};
void decaudin_g(const DecaudinG& row);

struct DecaudinP {
    const float* g_up;
    const float* g_mid;
    const float* g_down;
    float* p;
    int width;
    DecaudinK k;
};
void decaudin_p(const DecaudinP& row);

void decaudin_image(std::span<const DecaudinChannel> channels,
                    DecaudinJoin join,
                    const core::ImageView<std::uint8_t>& out);

}  // namespace ink::edge
