#pragma once

#include <algorithm>
#include <cstdint>

#include "edge/edge_image.h"

namespace ink::methods {

/// How many pixels an image has that are not 0, and how many of them have one of the other image
/// within so many rows and columns.
struct Near {
    int of = 0;
    int near = 0;

    [[nodiscard]] double share() const { return static_cast<double>(near) / std::max(of, 1); }
};

inline Near count_near(const core::Image<std::uint8_t>& of,
                       const core::Image<std::uint8_t>& to,
                       int within_px) {
    Near found;
    for (int y = 0; y < of.height_px(); ++y) {
        for (int x = 0; x < of.width_px(); ++x) {
            if (of.at(x, y) == 0) continue;
            bool is_near = false;
            for (int v = y - within_px; v <= y + within_px; ++v)
                for (int u = x - within_px; u <= x + within_px; ++u)
                    is_near = is_near || (to.contains(u, v) && to.at(u, v) != 0);
            ++found.of;
            found.near += is_near ? 1 : 0;
        }
    }
    return found;
}

/// F of an image, where what lies within 2 px is found.
inline double f_within_two_px(const edge::EdgeImage& lines,
                              const core::Image<std::uint8_t>& labels) {
    const double precision = count_near(lines, labels, 2).share();
    const double recall = count_near(labels, lines, 2).share();
    return 2 * precision * recall / (precision + recall);
}

}  // namespace ink::methods
