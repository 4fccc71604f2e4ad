#pragma once

#include <array>
#include <string_view>

namespace ink::harness {

/// What a cell was measured for: the column `study` of rows.csv.
enum class Study { compare, stress, motion, roll, scaling, skips, bound, tune };

inline constexpr std::array<std::string_view, 8> kStudyNames = {
    "compare", "stress", "motion", "roll", "scaling", "skips", "bound", "tune"};

/// "compare", "stress", ...
[[nodiscard]] constexpr std::string_view name(Study study) {
    return kStudyNames[static_cast<std::size_t>(study)];
}

}  // namespace ink::harness
