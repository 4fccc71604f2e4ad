#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <type_traits>
#include <vector>

#include "core/image.h"
#include "core/simd.h"

namespace ink::edge {

/// An image inside a margin, at a chosen offset from where its memory begins, so that rows lie
/// anywhere between cache lines.
template <class T>
class Guarded {
  public:
    static constexpr int kMargin_px = 3;

    Guarded(int width_px, int height_px, int offset_px, T fill)
        : width_px_(width_px),
          height_px_(height_px),
          stride_(width_px + 2 * kMargin_px),
          offset_px_(offset_px),
          fill_(fill),
          pixels_(static_cast<std::size_t>(stride_) * (height_px + 2 * kMargin_px) + offset_px,
                  fill) {}

    [[nodiscard]] core::ImageView<T> view() {
        T* origin = pixels_.data() + offset_px_ + kMargin_px * stride_ + kMargin_px;
        return {origin, width_px_, height_px_, stride_};
    }
    [[nodiscard]] std::vector<T>& pixels() { return pixels_; }

    /// Whether nothing but the image itself was written.
    [[nodiscard]] bool is_margin_whole() const {
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            const auto at = static_cast<std::ptrdiff_t>(i) - offset_px_;
            const auto x = at % stride_ - kMargin_px;
            const auto y = at / stride_ - kMargin_px;
            const bool is_inside = at >= 0 && x >= 0 && x < width_px_ && y >= 0 && y < height_px_;
            if (!is_inside && pixels_[i] != fill_) return false;
        }
        return true;
    }

  private:
    int width_px_;
    int height_px_;
    int stride_;
    int offset_px_;
    T fill_;
    std::vector<T> pixels_;
};

/// Codes that bring out every rounding and overflow: all values, extremes only, or small steps;
/// floats of -1..1.
template <class T>
void fill_adversarially(std::vector<T>& pixels, unsigned seed) {
    std::mt19937 random(seed);
    for (T& pixel : pixels) {
        const auto dice = static_cast<std::uint32_t>(random());
        const auto kind = seed % 3;
        if constexpr (std::is_floating_point_v<T>) {
            const auto value = static_cast<float>(static_cast<std::int32_t>(dice)) * 0x1p-31F;
            pixel = kind == 0 ? value : kind == 1 ? std::round(value) : 0.5F + value * 1e-6F;
        } else {
            const auto top = static_cast<std::uint32_t>(static_cast<T>(~T{0}));
            const std::uint32_t extreme = dice % 2 == 0 ? dice / 2 % 3 : top - dice / 2 % 3;
            pixel = static_cast<T>(kind == 0 ? dice : kind == 1 ? extreme : top / 2 + dice % 5);
        }
    }
}

/// Runs `check` once on each SIMD target of this machine.
template <class Check>
void on_every_target(Check check) {
    for (const core::SimdTarget& target : core::simd_targets()) {
        SCOPED_TRACE(target.name);
        const core::ForcedSimdTarget forced(target);
        check();
        if (testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace ink::edge
