#include "score/polarity.h"

#include <algorithm>

namespace ink::score {

bool has_dark_lines(const core::Image<std::uint8_t>& image) {
    constexpr double kLeastLight = 0.75;
    if (image.is_empty()) return false;
    const auto* end = image.data() + image.size();
    const auto light = std::count_if(image.data(), end, [](int v) { return v >= 128; });
    const auto [least, most] = std::minmax_element(image.data(), end);
    return *least != *most &&
           static_cast<double>(light) > kLeastLight * static_cast<double>(image.size());
}

void invert(core::Image<std::uint8_t>& image) {
    std::transform(image.data(), image.data() + image.size(), image.data(), [](int v) {
        return static_cast<std::uint8_t>(255 - v);
    });
}

}  // namespace ink::score
