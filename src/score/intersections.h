#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/image.h"
#include "truth/curve.h"

namespace ink::score {

/// Which intersections a score requires.
///
/// Where two surfaces cross, the line may bend by anything. Of creases, flatter ones than the
/// crease angle are no lines of the truth; a crossing that bends as little asks methods for what
/// they are excused from elsewhere.
enum class Intersections : std::uint8_t {
    above_crease,  ///< those that bend at least by the crease angle; flatter ones are ignored
    all
};

/// "above_crease", "all": the spelling of options, files and columns.
inline constexpr std::array<std::string_view, 2> kIntersectionNames = {"above_crease", "all"};

[[nodiscard]] constexpr std::string_view name(Intersections intersections) {
    return kIntersectionNames[static_cast<std::size_t>(intersections)];
}

/// A truth image as it counts: where `below_crease` (of its size) is not 0, `labels` becomes
/// `ignore`, unless all intersections count.
[[nodiscard]] core::Image<std::uint8_t> counted_labels(
    const core::Image<std::uint8_t>& labels,
    const core::Image<std::uint8_t>& below_crease,
    Intersections intersections);

/// The curves that count, in their order.
[[nodiscard]] std::vector<truth::Curve> counted_curves(std::span<const truth::Curve> curves,
                                                       double crease_rad,
                                                       Intersections intersections);

}  // namespace ink::score
