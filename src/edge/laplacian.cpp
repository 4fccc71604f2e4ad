#include "edge/laplacian.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "edge/laplacian_plan.h"

namespace ink::edge {
namespace {

/// The value of a number known modulo 2^bits between -2^(bits-1) and 2^(bits-1) - 1.
int nearest_to_zero(int value, int bits) {
    const int modulus = 1 << bits;
    const int low = value & (modulus - 1);
    return low >= modulus / 2 ? low - modulus : low;
}

Reading reading_of(const LaplacianResponse& response) {
    switch (response.response) {
        case Response::absolute:
            return response.code_wraps ? Reading::wrapped_absolute : Reading::absolute;
        case Response::positive:
            return response.code_wraps ? Reading::wrapped_positive : Reading::positive;
        case Response::wrap:
            break;
    }
    return Reading::literal;
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

LaplacianPlan::LaplacianPlan(const LaplacianResponse& response, int store_bits)
    : reading(reading_of(response)),
      code_shift(store_bits - response.code_bits),
      keep(~((1U << response.clip_bits) - 1)),
      low(0),
      low_right(0),
      double_first(0),
      right(std::max(-response.scale_bits, 0)),
      left(std::min(std::max(response.scale_bits, 0), 8)) {
    assert(response.clip_bits >= 0 && response.clip_bits <= 15);
    assert(response.scale_bits >= -15 && response.scale_bits <= 15);
    assert(response.code_bits >= 1 && response.code_bits <= store_bits);
    if (reading == Reading::absolute || reading == Reading::positive) {
        low = right < 2 ? keep & 3 : 0;
        low_right = std::min(right, 1);
        double_first = std::max(2 - right, 0);
        right = std::max(right - 2, 0);
        keep >>= 2;
    } else if (reading == Reading::literal) {
        keep &= (1U << response.code_bits) - 1;
    }
    // Lanes cannot be shifted by their own width or more; nothing would be left.
    if (right >= store_bits || (reading == Reading::literal && left >= 8)) {
        keep = low = 0;
        right = left = 0;
    }
}

}  // namespace ink::edge
