#pragma once

#include <array>
#include <optional>
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

/// The study of that name; nothing for another word.
[[nodiscard]] constexpr std::optional<Study> find_study(std::string_view word) {
    for (std::size_t i = 0; i < kStudyNames.size(); ++i) {
        if (kStudyNames[i] == word) return static_cast<Study>(i);
    }
    return std::nullopt;
}

}  // namespace ink::harness
