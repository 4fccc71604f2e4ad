#pragma once

namespace ink::harness {

/// What a cell was measured for: the column `study` of rows.csv. A study of one's own has a name of
/// its own.
struct Study {
    static constexpr const char* compare = "compare";
    static constexpr const char* stress = "stress";
    static constexpr const char* motion = "motion";
    static constexpr const char* tune = "tune";
};

}  // namespace ink::harness
