#pragma once

#include "edge/laplacian.h"

namespace ink::edge {

/// What is known about L.
enum class Reading {
    absolute,          ///< |L|, all of it
    positive,          ///< max(L, 0), all of it
    wrapped_absolute,  ///< |L| of an L known modulo 2^code_bits
    wrapped_positive,
    literal,  ///< L modulo 2^code_bits
};

/// A response as the steps of the kernel. v is first doubled, then joined with low bits, shifted
/// right, shifted left; doublings saturate, eight of them anything but 0.
struct LaplacianPlan {
    Reading reading;
    int code_shift;    ///< up and down again, to read a wrapped code's sign
    unsigned keep;     ///< mask of v, which is |L| / 4 where all of L is known, else |L| or L
    unsigned low;      ///< mask of the low two bits of |L|, where v is |L| / 4
    int low_right;     ///< what these are shifted by
    int double_first;  ///< how often v is doubled before they join
    int right;
    int left;

    LaplacianPlan(const LaplacianResponse& response, int store_bits);
    /// |L| or max(L, 0) with just its two low bits clipped: the default.
    [[nodiscard]] bool is_quadruple() const {
        return (reading == Reading::absolute || reading == Reading::positive) && low == 0 &&
               right == 0 && double_first + left == 2 && (keep & 255) == 255;
    }
};

}  // namespace ink::edge
