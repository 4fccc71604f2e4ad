#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/image.h"

/// Small images written as text: '.' is 0, a digit d is d times `per_digit`, '#' is 255.
using Rows = std::vector<std::string>;
using Image = ink::core::Image<std::uint8_t>;

inline Image image_of(const Rows& rows, int per_digit = 1) {
    Image image(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
            const int value = c == '.' ? 0 : c == '#' ? 255 : (c - '0') * per_digit;
            image.at(x, y) = static_cast<std::uint8_t>(value);
        }
    }
    return image;
}

/// Each pixel is a random value of 1..`max_value` with probability `share`, else 0.
inline Image random_image(
    int width_px, int height_px, double share, int max_value, std::mt19937& random) {
    Image image(width_px, height_px);
    std::bernoulli_distribution is_set(share);
    std::uniform_int_distribution<int> value(1, max_value);
    for (std::size_t i = 0; i < image.size(); ++i) {
        image.data()[i] = static_cast<std::uint8_t>(is_set(random) ? value(random) : 0);
    }
    return image;
}

inline Image transposed(const Image& image) {
    Image result(image.height_px(), image.width_px());
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x)
            result.at(y, x) = image.at(x, y);
    }
    return result;
}
