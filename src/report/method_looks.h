#pragma once

#include <cstddef>
#include <string_view>

#include "draw/palette.h"
#include "method/family.h"
#include "report/svg.h"

namespace ink::report {

/// How a method is told from all others: the family by colour, the method by marker, a preset of it
/// by being hollow.
struct Look {
    method::Family family = method::Family::other;
    method::Marker marker = method::Marker::circle;
    bool is_hollow = false;

    [[nodiscard]] draw::Colour colour() const;
    [[nodiscard]] bool operator==(const Look&) const = default;
};

[[nodiscard]] draw::Colour colour_of(method::Family family);

/// The method whose settings `method` changes, by the registry, or for a name that is not there by
/// its ending `_tuned`, which `inkbench tune` gives; else `method` itself.
[[nodiscard]] std::string_view base_of(std::string_view method);

/// The look of `method` as the registry has it, hollow for a preset. One whose base is not there is
/// of the family `other`, its marker by its place `nth` on the chart.
[[nodiscard]] Look look_of(std::string_view method, std::size_t nth = 0);

/// A marker round (x, y), as large as a circle of `radius`, on a white rim.
void draw_marker(Svg& svg, double x, double y, double radius, const Look& look);

}  // namespace ink::report
