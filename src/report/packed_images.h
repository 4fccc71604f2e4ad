#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/run_data.h"

namespace ink::report {

/// The images of each run as JSON, as page/images.js reads them: an array with an object per run,
/// from "scene\nview" to {"width", "height", "truth": PNG, "methods": {name: PNG}}; PNGs are
/// base64 of 8-bit grey with a code a pixel (draw::Mark; truth::LineClass for the truth).
///
/// Where they would take more than `budget_bytes`, all are shrunk by 2, 4, then 8 (errors and lines
/// win over paper); where even that is too much, the last views of each scene are left out, and
/// then the last scenes. Throws core::Error for an image that cannot be read.
[[nodiscard]] std::string packed_images(const std::vector<experiment::RunData>& runs,
                                        std::size_t budget_bytes);

}  // namespace ink::report
