#include "harness/clock/yardstick.h"

#include <cstdlib>

namespace ink::harness {
namespace {

constexpr int kWidth_px = 320;
constexpr int kHeight_px = 180;
constexpr int kPasses = 10;
constexpr std::uint32_t kLinks = 29'000;

}  // namespace

Yardstick::Yardstick() : from_(kWidth_px, kHeight_px), to_(kWidth_px, kHeight_px) {
    for (int y = 0; y < kHeight_px; ++y)
        for (int x = 0; x < kWidth_px; ++x)
            from_.at(x, y) = static_cast<std::uint8_t>((x * y) >> 4);
}

void Yardstick::work() {
    for (int pass = 0; pass < kPasses; ++pass)
        filter();
    chain();
}

void Yardstick::chain() {
    for (std::uint32_t i = 0; i < kLinks; ++i) {
        link_ = 3.7F * link_ * (1 - link_);  // never settles
        if (link_ > 0.5F) ++steps_up_;
    }
}

void Yardstick::filter() {
    for (int y = 1; y + 1 < kHeight_px; ++y) {
        const std::uint8_t* above = from_.row(y - 1);
        const std::uint8_t* here = from_.row(y);
        const std::uint8_t* below = from_.row(y + 1);
        std::uint8_t* to = to_.row(y);
        for (int x = 1; x + 1 < kWidth_px; ++x) {
            const int sum = here[x - 1] + here[x + 1] + above[x] + below[x] - 4 * here[x];
            to[x] = static_cast<std::uint8_t>(std::abs(sum) / 4);
        }
    }
}

}  // namespace ink::harness
