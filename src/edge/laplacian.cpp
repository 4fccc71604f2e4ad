#include "edge/laplacian.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace ink::edge {
namespace {

/// The value of a number known modulo 2^bits between -2^(bits-1) and 2^(bits-1) - 1.
int nearest_to_zero(int value, int bits) {
    const int modulus = 1 << bits;
    const int low = value & (modulus - 1);
    return low >= modulus / 2 ? low - modulus : low;
}

}  // namespace

std::uint8_t respond(int laplacian, const LaplacianResponse& r) {
    assert(r.clip_bits >= 0 && r.clip_bits <= 15 && std::abs(r.scale_bits) <= 15);
    assert(r.code_bits >= 1 && r.code_bits <= 16);
    const int keep = ~((1 << r.clip_bits) - 1);
    const int left = std::max(r.scale_bits, 0);
    const int right = std::max(-r.scale_bits, 0);
    if (r.response == Response::wrap) {
        const int v = laplacian & ((1 << r.code_bits) - 1) & keep;
        return static_cast<std::uint8_t>(static_cast<unsigned>(v >> right) << left);
    }
    if (r.code_wraps) laplacian = nearest_to_zero(laplacian, r.code_bits);
    const int read = r.response == Response::absolute ? std::abs(laplacian) : laplacian;
    const int v = (std::max(read, 0) & keep) >> right;
    return v > 255 >> left ? std::uint8_t{255} : static_cast<std::uint8_t>(v << left);
}

}  // namespace ink::edge
