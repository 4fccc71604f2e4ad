#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "draw/palette.h"
#include "report/svg.h"

namespace ink::report {

/// What a method works on: what its colour says on charts.
enum class Family { packed, full_buffers, ids, edges, other };

inline constexpr std::array kFamilies = {
    Family::packed, Family::full_buffers, Family::ids, Family::edges, Family::other};

enum class Shape { circle, square, diamond, up, down };

/// How a method is told from all others: the family by colour, the method by shape, a tuned variant
/// by being hollow.
struct Look {
    Family family = Family::other;
    Shape shape = Shape::circle;
    bool is_hollow = false;

    [[nodiscard]] draw::Colour colour() const;
    [[nodiscard]] bool operator==(const Look&) const = default;
};

[[nodiscard]] draw::Colour colour_of(Family family);

/// "packed", "full buffers", ...: a word or two for a legend.
[[nodiscard]] std::string_view label_of(Family family);

/// The look of `method`. `<name>_tuned` is `<name>`, hollow. One that is in no table is of the
/// family `other`, its shape by its place `nth` on the chart.
[[nodiscard]] Look look_of(std::string_view method, std::size_t nth = 0);

/// A marker round (x, y), as large as a circle of `radius`, on a white rim.
void draw_marker(Svg& svg, double x, double y, double radius, const Look& look);

}  // namespace ink::report
