#pragma once

#include <cstdint>

#include "core/image.h"

namespace ink::shade {

/// Every pixel becomes the strongest one within a disc round it: a line of one pixel becomes
/// `diameter_px` wide (1 changes nothing).
///
/// A disc of odd diameter has its centre on a pixel centre, one of even diameter on the corner
/// above and left of it; it holds the pixel centres at most diameter/2 away. Outside the image is
/// nothing. Costs in proportion to the pixels that are not 0 times the disc.
[[nodiscard]] core::Image<std::uint8_t> widen(const core::Image<std::uint8_t>& edge_responses,
                                              int diameter_px);

}  // namespace ink::shade
