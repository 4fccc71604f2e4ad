#pragma once

#include <cstdint>

#include "core/image.h"
#include "edge/edge_image.h"

namespace ink::edge {

/// The pixels drawn at least as strongly as `at_least` (1..255): edge response >= at_least.
///
/// Same size as `image`; an empty image gives an empty mask. Another range is a caller's bug: 0
/// would call the bare background a line.
[[nodiscard]] Mask threshold(const EdgeImage& image, int at_least);

/// The same into a mask of the same size, rows shared among `threads`. May be done in place.
void threshold(const core::ImageView<const std::uint8_t>& edge_responses,
               int at_least,
               const core::ImageView<std::uint8_t>& mask,
               int threads = 1);

}  // namespace ink::edge
