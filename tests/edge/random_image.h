#pragma once

#include <random>

#include "core/image.h"

namespace ink::edge {

/// Pixels drawn evenly from low..high (whole numbers, as `T`).
template <class T>
core::Image<T> random_image(int width_px, int height_px, std::pair<int, int> range, int seed) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    std::uniform_int_distribution<int> pixel(range.first, range.second);
    core::Image<T> image(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            image.at(x, y) = static_cast<T>(pixel(random));
    }
    return image;
}

}  // namespace ink::edge
