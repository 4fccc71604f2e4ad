#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/side_differences_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/side_differences.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V difference(V a, V b) {
    return hn::Or(hn::SaturatedSub(a, b), hn::SaturatedSub(b, a));  // one of them is 0
}

/// The larger of the differences from `a` to its two neighbours.
template <class V>
HWY_INLINE V most_side(V a, V b, V c) {
    return hn::Max(difference(a, b), difference(a, c));
}

void side_rows(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               Sides sides,
               int gain_bits) {
    constexpr int kLanes = HWY_LANES(std::uint8_t);
    const bool is_square = sides == Sides::square;
    for (int y = 0; y < out.height_px; ++y) {
        const std::uint8_t* upper = codes.row(y);
        const std::uint8_t* lower = upper + codes.stride;
        std::uint8_t* to = out.row(y);
        cover<std::uint8_t, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto a = hn::LoadU(d, upper + x);
            const auto b = hn::LoadU(d, upper + x + 1);
            const auto c = hn::LoadU(d, lower + x);
            auto most = most_side(a, b, c);
            if (is_square) most = hn::Max(most, most_side(hn::LoadU(d, lower + x + 1), b, c));
            for (int bit = 0; bit < gain_bits; ++bit)
                most = hn::SaturatedAdd(most, most);
            hn::StoreU(most, d, to + x);
        });
    }
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(side_rows);

}  // namespace

void side_differences(const core::ImageView<const std::uint8_t>& codes,
                      const core::ImageView<std::uint8_t>& out,
                      Sides sides,
                      int gain_bits) {
    HWY_DYNAMIC_DISPATCH(side_rows)(codes, out, sides, gain_bits);
}

}  // namespace ink::edge
#endif
