#pragma once

#include <cstdint>
#include <span>

#include "core/image.h"
#include "truth/curve.h"

namespace ink::truth {

inline constexpr std::uint32_t kNoCurve = 0xffffffffU;

/// Which curve drew each pixel of the truth image: an index into `curves`, kNoCurve where none did.
///
/// Of several curves in a pixel the one of the lowest class counts, of those the first, so that its
/// class is the pixel's label in draw_labels. Not thinned, and crowded blocks are not left out.
[[nodiscard]] core::Image<std::uint32_t> draw_curve_map(std::span<const Curve> curves,
                                                        int width_px,
                                                        int height_px);

}  // namespace ink::truth
