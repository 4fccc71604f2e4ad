#include "edge/laplacian_plan.h"

#include <algorithm>
#include <cassert>

namespace ink::edge {
namespace {

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
