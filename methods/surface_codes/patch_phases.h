#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "methods/surface_codes/smooth_mesh.h"

namespace ink::methods {

/// Numbers that codes take. What is empty has a number apart from them.
struct CodeRange {
    int lowest = 2;
    int highest = 255;
    /// Codes that differ by less belong together.
    int least_difference = 2;
    /// Which numbers free patches get: two sets of codes must not agree in them.
    bool is_second = false;
};

/// Per face a code from its distance, in units of kStep: the distance and the phase of its patch, a
/// whole number of steps, to and fro between the ends of the range.
///
/// Codes of a patch so change by no more steps than its distances. Phases are found patch by patch,
/// the largest area first, so that as little as possible of the borders with those before has codes
/// that belong together; where a patch is free, patches that follow each other in the file get
/// phases far apart.
[[nodiscard]] std::vector<std::uint8_t> phased_codes(const SmoothMesh& mesh,
                                                     std::span<const std::int32_t> distances,
                                                     const CodeRange& range);

}  // namespace ink::methods
