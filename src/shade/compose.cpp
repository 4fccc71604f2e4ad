#include "shade/compose.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/srgb.h"
#include "edge/set_pixels.h"

namespace ink::shade {
namespace {

/// Ranks 0..15 of a 4x4 square (Bayer 1973): the order in which its pixels are raised.
constexpr int kBayer4[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

/// A row of the disc: pixels [x0, x1) beside the one that is widened.
struct DiscRow {
    int y = 0;
    int x0 = 0;
    int x1 = 0;
};

std::vector<DiscRow> disc_rows(int diameter_px) {
    // In half pixels, from the disc's centre to pixel centres: whole numbers.
    const int first = -(diameter_px / 2);
    const auto is_inside = [&](int x, int y) {
        const int shift = diameter_px % 2 == 0 ? 1 : 0;
        const int dx = 2 * x + shift;
        const int dy = 2 * y + shift;
        return dx * dx + dy * dy <= diameter_px * diameter_px;
    };
    std::vector<DiscRow> rows;
    for (int y = first; y < first + diameter_px; ++y) {
        DiscRow row{y, first, first + diameter_px};
        while (row.x0 < row.x1 && !is_inside(row.x0, y))
            ++row.x0;
        while (row.x1 > row.x0 && !is_inside(row.x1 - 1, y))
            --row.x1;
        if (row.x0 < row.x1) rows.push_back(row);
    }
    return rows;
}

std::uint8_t channel_to_8_bit(float brightness) {
    if (!(brightness > 0)) return 0;
    return brightness >= 1 ? 255 : static_cast<std::uint8_t>(brightness * 255 + 0.5F);
}

/// Averages images of `kChannels` bytes a pixel.
template <int kChannels, class Pixel>
core::Image<Pixel> average_bytes(const core::Image<Pixel>& image, int n) {
    static_assert(sizeof(Pixel) == kChannels);
    assert(n >= 1 && image.width_px() % n == 0 && image.height_px() % n == 0);
    core::Image<Pixel> result(image.width_px() / n, image.height_px() / n);
    const int count = n * n;
    std::vector<int> sums(static_cast<std::size_t>(result.width_px()) * kChannels);
    for (int y = 0; y < result.height_px(); ++y) {
        sums.assign(sums.size(), count / 2);
        for (int j = 0; j < n; ++j) {
            const auto* from = reinterpret_cast<const std::uint8_t*>(image.row(y * n + j));
            for (std::size_t x = 0; x < sums.size(); x += kChannels) {
                for (int i = 0; i < n; ++i) {
                    for (std::size_t c = 0; c < kChannels; ++c)
                        sums[x + c] += *from++;
                }
            }
        }
        auto* to = reinterpret_cast<std::uint8_t*>(result.row(y));
        for (const int sum : sums)
            *to++ = static_cast<std::uint8_t>(sum / count);
    }
    return result;
}

std::uint8_t byte_of_light(double light) {
    return static_cast<std::uint8_t>(std::lround(255 * core::value_of(light)));
}

std::array<double, 256> light_of_bytes() {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = core::light_of(static_cast<double>(i) / 255);
    return light;
}

}  // namespace

std::array<int, 3> top_levels(DitherFormat format) {
    switch (format) {
        case DitherFormat::rgb565:
            return {31, 63, 31};
        case DitherFormat::rgb332:
            return {7, 7, 3};
        case DitherFormat::none:
            break;
    }
    return {255, 255, 255};
}

core::Image<Rgb> dither(core::Image<Rgb> image, DitherFormat format) {
    const std::array<int, 3> top = top_levels(format);
    for (int y = 0; y < image.height_px(); ++y) {
        Rgb* row = image.row(y);
        for (int x = 0; x < image.width_px(); ++x) {
            const int rank = kBayer4[y & 3][x & 3];
            for (int c = 0; c < 3; ++c) {
                const int steps = top[static_cast<std::size_t>(c)];
                const int scaled = row[x][c] * steps;
                const int rest = scaled % 255;
                const int level = scaled / 255 + (32 * rest > 255 * (2 * rank + 1) ? 1 : 0);
                row[x][c] = static_cast<std::uint8_t>((level * 255 + steps / 2) / steps);
            }
        }
    }
    return image;
}

core::Image<std::uint8_t> widen(const core::Image<std::uint8_t>& edge_responses, int diameter_px) {
    assert(diameter_px >= 1);
    if (diameter_px == 1) return edge_responses;
    const int width = edge_responses.width_px();
    const int height = edge_responses.height_px();
    core::Image<std::uint8_t> result(width, height);
    const std::vector<DiscRow> rows = disc_rows(diameter_px);
    for (int y = 0; y < height; ++y) {
        edge::visit_set_pixels(edge_responses.row(y), width, [&](int x) {
            const std::uint8_t edge_response = edge_responses.row(y)[x];
            for (const DiscRow& row : rows) {
                if (y + row.y < 0 || y + row.y >= height) continue;
                std::uint8_t* to = result.row(y + row.y);
                for (int i = std::max(x + row.x0, 0); i < std::min(x + row.x1, width); ++i)
                    to[i] = std::max(to[i], edge_response);
            }
        });
    }
    return result;
}

Rgb to_8_bit(const glm::vec3& color) {
    return {channel_to_8_bit(color.r), channel_to_8_bit(color.g), channel_to_8_bit(color.b)};
}

core::Image<Rgb> compose(const core::Image<std::uint8_t>& edge_responses,
                         core::Image<Rgb> image,
                         const Ink& ink) {
    assert(edge_responses.width_px() == image.width_px());
    assert(edge_responses.height_px() == image.height_px());
    for (std::size_t i = 0; i < edge_responses.size(); ++i) {
        if (edge_responses.data()[i] >= ink.threshold) image.data()[i] = ink.color;
    }
    return image;
}

core::Image<Rgb> average(const core::Image<Rgb>& image, int n) {
    return average_bytes<3>(image, n);
}

core::Image<std::uint8_t> average(const core::Image<std::uint8_t>& image, int n) {
    return average_bytes<1>(image, n);
}

core::Image<glm::u8vec3> lay_ink(const core::Image<std::uint8_t>& shares,
                                 core::Image<glm::u8vec3> image,
                                 const glm::u8vec3& color) {
    assert(shares.size() == image.size());
    const std::array<double, 256> light = light_of_bytes();
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double share = shares.data()[i] / 255.0;
        if (share == 0) continue;
        glm::u8vec3& pixel = image.data()[i];
        for (int channel = 0; channel < 3; ++channel) {
            const double under = light[pixel[channel]], over = light[color[channel]];
            pixel[channel] = byte_of_light(under + share * (over - under));
        }
    }
    return image;
}

}  // namespace ink::shade
