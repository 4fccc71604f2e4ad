#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studies/motion_rows.h"
#include "studies/roll_study.h"

namespace ink::report {

/// What the part on motion is about.
[[nodiscard]] std::string_view motion_intro();

/// Flicker, pops and false lines per method and by sequence; the cube roll with predicted and
/// measured angles. "" if neither was studied.
[[nodiscard]] std::string motion_html(const std::vector<studies::MotionRow>& rows,
                                      const std::vector<studies::RollCurve>& rolls);

}  // namespace ink::report
