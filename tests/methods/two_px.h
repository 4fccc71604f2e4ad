#pragma once

#include <algorithm>
#include <cstdint>

#include "edge/edge_image.h"

namespace ink::methods {

/// F of an image, where what lies within 2 px is found.
inline double f_within_two_px(const edge::EdgeImage& lines,
                              const core::Image<std::uint8_t>& labels) {
    const auto share_near = [](const auto& of, const auto& to) {
        int count = 0, near = 0;
        for (int y = 0; y < of.height_px(); ++y) {
            for (int x = 0; x < of.width_px(); ++x) {
                if (of.at(x, y) == 0) continue;
                ++count;
                bool is_near = false;
                for (int v = std::max(y - 2, 0); v <= std::min(y + 2, of.height_px() - 1); ++v)
                    for (int u = std::max(x - 2, 0); u <= std::min(x + 2, of.width_px() - 1); ++u)
                        is_near |= to.at(u, v) != 0;
                near += is_near;
            }
        }
        return static_cast<double>(near) / std::max(count, 1);
    };
    const double precision = share_near(lines, labels), recall = share_near(labels, lines);
    return 2 * precision * recall / (precision + recall);
}

}  // namespace ink::methods
