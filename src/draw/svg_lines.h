#pragma once

#include <fmt/format.h>

#include <string>

#include "truth/line_class.h"

namespace ink::draw {

/// The classes in the order of drawing: where lines meet, the class that wins lies on top.
inline constexpr truth::LineClass kDrawnOrder[] = {truth::LineClass::seam,
                                                   truth::LineClass::intersection,
                                                   truth::LineClass::crease,
                                                   truth::LineClass::boundary,
                                                   truth::LineClass::contour};

/// Up to so many decimals without idle zeros.
[[nodiscard]] inline std::string svg_number(double number, int decimals) {
    std::string text = fmt::format("{:.{}f}", number, decimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

}  // namespace ink::draw
