#include "shade/compose.h"

#include <cassert>
#include <utility>
#include <vector>

namespace ink::shade {
namespace {

std::uint8_t to_8_bit(float brightness) {
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

}  // namespace

Rgb to_8_bit(const glm::vec3& color) {
    return {to_8_bit(color.r), to_8_bit(color.g), to_8_bit(color.b)};
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

}  // namespace ink::shade
