#pragma once

#include <glm/vec3.hpp>

#include "buffers/code_layout.h"
#include "buffers/packed_sink.h"
#include "core/image.h"
#include "edge/edge_image.h"

namespace ink::buffers {

/// Codes as an image, 0 black and the largest of its bits white: one field as grey; of more, the
/// first three as red, green and blue (of four, which are depth and normal, the normal's).
///
/// `codes` has an image for each of the layout's planes, all of one size.
[[nodiscard]] core::Image<glm::u8vec3> code_image(const FrameCodes& codes,
                                                  const CodeLayout& layout);

/// Edge responses in grey, brightened or dimmed so that `threshold` (1..255) comes out as 128; what
/// is twice as strong is white.
[[nodiscard]] core::Image<glm::u8vec3> response_image(const edge::EdgeImage& edge_responses,
                                                      int threshold);

}  // namespace ink::buffers
