#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

#include "core/image.h"
#include "edge/decaudin_filter.h"
#include "edge/laplacian.h"
#include "edge/laplacian_f32x4.h"
#include "edge/side_differences.h"

/// The filters as their formulas have them, pixel by pixel: what every SIMD target must equal.
/// `at` is the middle pixel, `stride` the way to the row below.
namespace ink::edge::plain {

template <class T>
int laplacian_at(const T* at, std::ptrdiff_t stride) {
    return 4 * at[0] - at[-stride] - at[stride] - at[-1] - at[1];
}

template <class T>
std::uint8_t response_at(const T* at, std::ptrdiff_t stride, const LaplacianResponse& r) {
    const long laplacian = laplacian_at(at, stride);
    const long modulus = 1L << r.code_bits;
    const long wrapped = ((laplacian % modulus) + modulus) % modulus;
    if (r.response == Response::wrap) {
        long v = wrapped - wrapped % (1L << r.clip_bits);
        v = r.scale_bits >= 0 ? v << r.scale_bits : v >> -r.scale_bits;
        return static_cast<std::uint8_t>(v % 256);
    }
    long v = laplacian;
    if (r.code_wraps) v = wrapped >= modulus / 2 ? wrapped - modulus : wrapped;
    v = r.response == Response::absolute ? std::labs(v) : std::max(v, 0L);
    v -= v % (1L << r.clip_bits);
    v = r.scale_bits >= 0 ? v << r.scale_bits : v >> -r.scale_bits;
    return static_cast<std::uint8_t>(std::min(v, 255L));
}

inline std::uint8_t side_difference_at(const std::uint8_t* at,
                                       std::ptrdiff_t stride,
                                       Sides sides,
                                       int gain_bits) {
    const int a = at[0], b = at[1], c = at[stride], d = at[stride + 1];
    int most = std::max(std::abs(a - b), std::abs(a - c));
    if (sides == Sides::square) most = std::max({most, std::abs(b - d), std::abs(c - d)});
    return static_cast<std::uint8_t>(std::min(most << gain_bits, 255));
}

/// Between a sample and the one `step` away.
inline bool is_depth_jump(const float* at, std::ptrdiff_t step, const DepthJump& jump) {
    const float a = at[0], b = at[step];
    const float j = b - a, s0 = a - at[-step], s1 = at[2 * step] - b;
    const float excess = std::max(j - std::max(s0, s1), std::min(s0, s1) - j);
    return excess > std::max(a, b) * jump.least_share + jump.slack &&
           std::abs(j) > std::max(std::abs(s0), std::abs(s1)) * jump.ratio;
}

inline bool has_depth_jump_at(const float* at,
                              std::ptrdiff_t stride,
                              Sides sides,
                              const DepthJump& jump) {
    if (is_depth_jump(at, 1, jump) || is_depth_jump(at, stride, jump)) return true;
    return sides == Sides::square &&
           (is_depth_jump(at + stride, 1, jump) || is_depth_jump(at + 1, stride, jump));
}

/// Additions in the order that the kernels keep.
inline float decaudin_g_at(const float* at, std::ptrdiff_t stride) {
    const float* up = at - stride;
    const float* down = at + stride;
    const float c = *at;
    const float corners =
        std::abs(up[-1] - c) + std::abs(up[1] - c) + std::abs(down[-1] - c) + std::abs(down[1] - c);
    const float sides =
        std::abs(up[0] - c) + std::abs(at[-1] - c) + std::abs(at[1] - c) + std::abs(down[0] - c);
    return (corners + 2 * sides) * 0.125F;
}

inline float decaudin_p_at(const float* g, std::ptrdiff_t stride, const DecaudinK& k) {
    const float scale = k.place == KPlace::inside ? 1 / k.k : 1;
    const float factor = k.place == KPlace::inside ? 1 : 1 / k.k;
    float low = *g;
    float high = *g;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            low = std::min(low, g[dy * stride + dx]);
            high = std::max(high, g[dy * stride + dx]);
        }
    }
    const float d = (high - low) * scale;
    return std::min(d * d * factor, 1.0F);
}

inline float join(float joined, float p, DecaudinJoin how) {
    if (how == DecaudinJoin::max) return std::max(joined, p);
    if (how == DecaudinJoin::either) return joined + (p - joined * p);
    return joined + p * p;
}

inline std::uint8_t decaudin_response(float joined, DecaudinJoin how) {
    const float p = how == DecaudinJoin::length ? std::sqrt(joined) : joined;
    return static_cast<std::uint8_t>(std::min(p, 1.0F) * 255 + 0.5F);
}

inline std::uint8_t full_response_at(const FloatPlanes& planes,
                                     std::ptrdiff_t offset,
                                     const FullLaplacianResponse& r) {
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float* at = planes.origin[i] + offset;
        const float column = at[-planes.stride] + at[planes.stride];
        const float laplacian = (4 * *at - column) - (at[-1] + at[1]);
        const bool is_signed = r.sum == LaplacianSum::absolute_of_sum;
        const float term = r.weights[i] * (is_signed ? laplacian : std::abs(laplacian));
        sum = i == 0 ? term : sum + term;
    }
    sum = std::abs(sum);
    if (sum < r.threshold) return 0;
    return static_cast<std::uint8_t>(std::min(sum * (255 / r.full), 255.0F) + 0.5F);
}

template <class T>
T blurred_at(const T* at, std::ptrdiff_t stride, int code_bits) {
    const long modulus = 1L << code_bits;
    long sum = 8;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const long neighbour = at[dy * stride + dx];
            long way = neighbour - *at;
            if (code_bits > 0) {
                way = ((way % modulus) + modulus) % modulus;
                if (way >= modulus / 2) way -= modulus;
            }
            sum += (2 - std::abs(dx)) * (2 - std::abs(dy)) * way;
        }
    }
    const long value = *at + (sum >> 4);
    return static_cast<T>(code_bits > 0 ? value & (modulus - 1) : value);
}

inline float roberts_at(const float* at, std::ptrdiff_t stride) {
    const auto v = [&](int dx, int dy) { return at[dy * stride + dx]; };
    return std::abs(v(0, 0) - v(1, 1)) + std::abs(v(1, 0) - v(0, 1));
}

inline float sobel_first_at(const float* at, std::ptrdiff_t stride) {
    const auto v = [&](int dx, int dy) { return at[dy * stride + dx]; };
    const float above = v(-1, -1) + 2 * v(0, -1) + v(1, -1);
    const float below = v(-1, 1) + 2 * v(0, 1) + v(1, 1);
    const float right = v(1, -1) + 2 * v(1, 0) + v(1, 1);
    const float left = v(-1, -1) + 2 * v(-1, 0) + v(-1, 1);
    return (std::abs(above - below) + std::abs(right - left)) / 8;
}

inline float sobel_second_at(const float* at, std::ptrdiff_t stride) {
    const auto v = [&](int dx, int dy) { return at[dy * stride + dx]; };
    const float sum =
        v(-1, -1) + v(0, -1) + v(1, -1) + v(-1, 0) + v(1, 0) + v(-1, 1) + v(0, 1) + v(1, 1);
    return std::abs(8 * v(0, 0) - sum) / 3;
}

}  // namespace ink::edge::plain
