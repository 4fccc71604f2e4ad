#include "score/intersections.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace ink::score {

core::Image<std::uint8_t> counted_labels(const core::Image<std::uint8_t>& labels,
                                         const core::Image<std::uint8_t>& below_crease,
                                         Intersections intersections) {
    core::Image<std::uint8_t> counted = labels;
    if (intersections == Intersections::all) return counted;
    assert(labels.size() == below_crease.size());
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (below_crease.data()[i] != 0)
            counted.data()[i] = static_cast<std::uint8_t>(truth::LineClass::ignore);
    }
    return counted;
}

std::vector<truth::Curve> counted_curves(std::span<const truth::Curve> curves,
                                         double crease_rad,
                                         Intersections intersections) {
    std::vector<truth::Curve> counted;
    counted.reserve(curves.size());
    std::copy_if(
        curves.begin(), curves.end(), std::back_inserter(counted), [&](const truth::Curve& curve) {
            return intersections == Intersections::all ||
                   !truth::is_below_crease(curve, crease_rad);
        });
    return counted;
}

}  // namespace ink::score
