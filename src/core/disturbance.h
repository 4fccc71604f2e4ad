#pragma once

namespace ink::core {

/// How many times as long a loop takes while `others` threads do the same beside it: 1 is no
/// disturbance at all, 1.5 and more are two threads on one core.
///
/// The loop reads and writes four megabytes, a plane of a 720p frame, as drawing and scoring do.
/// Median of many pairs in turns; takes about a tenth of a second. `others` >= 0.
[[nodiscard]] double measure_disturbance(int others);

/// Up to here neighbours do not count: medians of two runs differ by as much anyway.
inline constexpr double kNoDisturbance = 1.03;

}  // namespace ink::core
