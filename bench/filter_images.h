#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "bench/bench_scene.h"
#include "core/image.h"

/// The images that filters are timed on.
namespace ink::bench {

/// An image with a border of two pixels or more all round, so that filters may read beyond the
/// frame. Rows begin where cache lines do.
template <class T>
class Padded {
  public:
    static constexpr int kBorder_px = 2;
    static constexpr int kStride_px = kWidth_px + 64;

    Padded() : pixels_(kStride_px, kHeight_px + 2 * kBorder_px + 1) {
        const auto address = reinterpret_cast<std::uintptr_t>(pixels_.row(kBorder_px));
        shift_px_ = static_cast<int>((64 - address % 64) / sizeof(T));
    }
    [[nodiscard]] T* row(int y) { return pixels_.row(y + kBorder_px) + shift_px_; }
    [[nodiscard]] const T* row(int y) const { return pixels_.row(y + kBorder_px) + shift_px_; }
    [[nodiscard]] core::Image<T>& pixels() { return pixels_; }
    [[nodiscard]] core::ImageView<const T> view() const {
        return {row(0), kWidth_px, kHeight_px, kStride_px};
    }

  private:
    core::Image<T> pixels_;
    int shift_px_ = 0;
};

/// Codes as a method makes them: ramps with a step here and there.
template <class T>
Padded<T> codes(std::uint32_t seed) {
    std::mt19937 random(seed);
    Padded<T> image;
    auto& pixels = image.pixels();
    for (int y = 0; y < pixels.height_px(); ++y) {
        auto code = static_cast<std::uint32_t>(random() % 256);
        for (int x = 0; x < pixels.width_px(); ++x) {
            const auto dice = static_cast<std::uint32_t>(random());
            code = dice % 40 == 0 ? dice >> 16 : code + dice % 3;
            pixels.at(x, y) = static_cast<T>(code);
        }
    }
    return image;
}

/// The same as floats, 0..1.
template <>
inline Padded<float> codes<float>(std::uint32_t seed) {
    auto bytes = codes<std::uint8_t>(seed);
    Padded<float> image;
    auto& pixels = image.pixels();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels.data()[i] = static_cast<float>(bytes.pixels().data()[i]) / 255;
    return image;
}

/// OpenCV's operators on the same images; part of the filter benchmarks.
void add_opencv_benchmarks();

}  // namespace ink::bench
