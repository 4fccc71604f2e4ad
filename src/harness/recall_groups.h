#pragma once

#include <array>
#include <string_view>

namespace ink::harness {

inline constexpr std::string_view kAboveCrease = "intersection_above_crease";
inline constexpr std::string_view kBelowCrease = "intersection_below_crease";

/// What recall is told of in tables: the five classes, then intersections again by whether they
/// bend at least by the crease angle.
inline constexpr std::array<std::string_view, 7> kRecallGroups = {
    "contour", "boundary", "crease", "intersection", "seam", kAboveCrease, kBelowCrease};

/// The same for people: each line stands in one group only.
inline constexpr std::array<std::string_view, 6> kShownRecallGroups = {
    "contour", "boundary", "crease", kAboveCrease, kBelowCrease, "seam"};

}  // namespace ink::harness
