#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ink::truth {

/// The class of a line, with the number it has in truth images (section 5 of the design).
///
/// Where two classes meet in a pixel the lower number wins. 6 is not used in files; `ignore` marks
/// pixels that are neither required nor penalised.
enum class LineClass : std::uint8_t {
    none = 0,
    contour = 1,
    boundary = 2,
    crease = 3,
    intersection = 4,
    seam = 5,
    ignore = 7,
};

/// The five classes that are scored, in the table's order.
inline constexpr std::array kLineClasses = {LineClass::contour,
                                            LineClass::boundary,
                                            LineClass::crease,
                                            LineClass::intersection,
                                            LineClass::seam};

/// "contour", "boundary", ...: the one spelling of columns, keys and legends.
[[nodiscard]] constexpr std::string_view name(LineClass c) {
    constexpr std::array<std::string_view, 8> kNames{
        "none", "contour", "boundary", "crease", "intersection", "seam", "?", "ignore"};
    const auto number = static_cast<std::size_t>(c);
    return number < kNames.size() ? kNames[number] : "?";
}

}  // namespace ink::truth
