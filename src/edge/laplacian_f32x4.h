#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// How four Laplacians become one sum S.
enum class LaplacianSum {
    of_absolutes,     ///< S = sum of weight |L|: nothing cancels
    absolute_of_sum,  ///< S = |sum of weight L|: what a packed sum of the channels would see
};

/// edge response = min(255 S / full, 255) rounded to nearest where S >= threshold, else 0.
struct FullLaplacianResponse {
    LaplacianSum sum = LaplacianSum::of_absolutes;
    std::array<float, 4> weights = {1, 1, 1, 1};  ///< >= 0 for `of_absolutes`
    float full = 1;                               ///< > 0: the sum that makes a full line
    float threshold = 0;                          ///< sums below it draw nothing
};

/// A full buffer: four planes of floats (depth and a normal, say) in images of one size and
/// stride.
struct FloatPlanes {
    std::array<const float*, 4> origin;  ///< pixel (0, 0) of each
    std::ptrdiff_t stride = 0;           ///< floats from one row to the next
};

/// MOTE's kernel 0 -1 0 / -1 4 -1 / 0 -1 0 over four channels at full precision: today's practice
/// on a full buffer, and what a packed byte is measured against.
///
/// L = (4 c - (up + down)) - (left + right), sums in the order of the channels; the same bits on
/// every SIMD target and number of threads, for finite values. One pixel round the image must be
/// readable and counts as neighbour; `out` has the image's size and overlaps no input. An empty
/// one writes nothing.
void laplacian_f32x4(const FloatPlanes& planes,
                     const core::ImageView<std::uint8_t>& out,
                     const FullLaplacianResponse& response,
                     int threads = 1);

}  // namespace ink::edge
