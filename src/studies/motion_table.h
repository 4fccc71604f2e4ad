#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/rows/row.h"
#include "harness/rows/side_table.h"
#include "score/motion.h"

namespace ink::studies {

/// How one method's lines behave on one sequence: a row whose view is the camera's path and whose
/// hash is of all its images, and a line of motion.csv.
struct MotionRow : harness::Row {
    int frames = 0;
    double frames_per_s = 60;
    double step_px = 0;  ///< by which the image moves a frame
    score::Flicker flicker = {};
    score::PopCount pops = {};
    std::vector<std::int64_t> lives = {};      ///< of false lines: entry i lived i + 1 frames
    std::int64_t lives_cut = 0;                ///< of them those that may live longer than was seen
    std::optional<score::InkChange> ink = {};  ///< nothing unless grey lines are scored
};

/// A sentence for each sequence on which the truth itself flickers, pops or has false lines: a run
/// with one is invalid.
[[nodiscard]] std::vector<std::string> motion_faults(const std::vector<MotionRow>& rows);

/// The columns of motion.csv: cell, the sequence, then flicker, pops and false lines.
/// Scores are empty if it failed.
[[nodiscard]] const harness::SideTable<MotionRow>& motion_table();

/// The columns of ink_motion.csv, where grey lines are scored: cell, how their ink changes.
[[nodiscard]] const harness::SideTable<MotionRow>& ink_motion_table();

/// How many false lines of a cell lived so long.
struct Life {
    int frames = 0;
    std::int64_t count = 0;
};

/// The columns of lives.csv: cell, frames, count.
[[nodiscard]] const harness::SideTable<Life>& lives_table();

/// A line per length of life that a false line of the cell had, each ended; "" without any.
[[nodiscard]] std::string life_lines(std::int64_t cell, const MotionRow& of);

}  // namespace ink::studies
