#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::edge {

/// What every method draws: one edge response per pixel, 0 no line .. 255 the strongest.
using EdgeImage = core::Image<std::uint8_t>;

/// A yes or no per pixel: 0 or 1.
using Mask = core::Image<std::uint8_t>;

}  // namespace ink::edge
