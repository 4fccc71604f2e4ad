#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "draw/palette.h"
#include "report/svg.h"
#include "studies/motion_rows.h"
#include "studies/roll_study.h"

namespace ink::report {

/// Lives of false lines as the chart sums them up: from `first` frames on, to the next class.
struct LifeClass {
    int first;
    std::string_view label;
    draw::Colour colour;
};
inline constexpr std::array<LifeClass, 4> kLifeClasses = {{
    {1, "1 frame", draw::kVermilion},
    {2, "2 or 3", draw::kOrange},
    {4, "4 to 7", draw::kSky},
    {8, "8 and more", draw::kBlue},
}};

/// How many false lines of a total lived as long as each of kLifeClasses says.
[[nodiscard]] std::array<std::int64_t, kLifeClasses.size()> lives_by_class(
    const std::vector<std::int64_t>& lives);

/// Per method three bars: flicker in thousandths of the drawn pixels, pops per feature and minute,
/// false lines per frame by how long they live. Without any method it says so.
[[nodiscard]] Svg motion_chart(const std::vector<studies::MotionTotal>& totals);

/// The colour of crease 0, 1, 2 on the roll's charts.
[[nodiscard]] draw::Colour colour_of_crease(int crease);

/// Recall of the cube's three creases against the roll, a panel per method that declares a code:
/// dashed where the code must lose a crease, shaded where its filter cannot show it. Without such a
/// method it says so.
[[nodiscard]] Svg roll_chart(const std::vector<studies::RollCurve>& curves);

}  // namespace ink::report
