#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/depth/depth.h"

namespace ink::raster {

/// The least and the greatest step of some vertices, whatever the format has.
struct StepRange {
    double least;
    double greatest;
};

/// Turns the q of `count` vertices into the steps of z24 or z16 that QuantisedDepth rounds down,
/// each rounded to float once, from `inv_w` in full: a step of z24 may be finer than q is as a
/// float. Steps run as linearly over the screen as q does. They are limited to those of the format:
/// see lanes_can_step(). Memory is read and written up to kLanePad.
[[nodiscard]] StepRange make_steps(const QuantisedDepth& depth,
                                   const double* inv_w,
                                   std::size_t count,
                                   float* q);

/// Whether the limits moved them by rounding alone, as they do at near and far themselves: half of
/// a step.
[[nodiscard]] inline bool lanes_can_step(const QuantisedDepth& depth, const StepRange& range) {
    constexpr double kMost = 0.75;
    return range.least >= 1 - kMost && range.greatest <= depth.steps() + kMost;
}

/// The low bits of `count` codes, a multiple of 16, at addresses aligned for vectors.
void narrow(const std::uint32_t* codes, std::size_t count, std::uint8_t* to);
void narrow(const std::uint32_t* codes, std::size_t count, std::uint16_t* to);

}  // namespace ink::raster
