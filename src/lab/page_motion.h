#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lab/motion_rows.h"
#include "lab/roll_study.h"

namespace ink::lab {

/// What the part on motion is about.
[[nodiscard]] std::string_view motion_intro();

/// Flicker, pops and false lines per method and by sequence; the cube roll with predicted and
/// measured angles. "" if neither was studied.
[[nodiscard]] std::string motion_html(const std::vector<MotionRow>& rows,
                                      const std::vector<RollCurve>& rolls);

}  // namespace ink::lab
