#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/threshold_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cassert>

#include "edge/row_bands.h"
#include "edge/threshold.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void threshold_row(const std::uint8_t* from, int at_least, std::uint8_t* to, int width) {
    cover_once<std::uint8_t, HWY_LANES(std::uint8_t)>(width, [=](auto d, int x) HWY_ATTR {
        const auto below = hn::Set(d, static_cast<std::uint8_t>(at_least - 1));
        const auto excess = hn::SaturatedSub(hn::LoadU(d, from + x), below);
        hn::StoreU(hn::Min(excess, hn::Set(d, 1)), d, to + x);
    });
}

void threshold_rows(const core::ImageView<const std::uint8_t>& edge_responses,
                    int at_least,
                    const core::ImageView<std::uint8_t>& mask) {
    for (int y = 0; y < mask.height_px; ++y)
        threshold_row(edge_responses.row(y), at_least, mask.row(y), mask.width_px);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

HWY_EXPORT(threshold_rows);

void threshold(const core::ImageView<const std::uint8_t>& edge_responses,
               int at_least,
               const core::ImageView<std::uint8_t>& mask,
               int threads) {
    assert(at_least >= 1 && at_least <= 255);
    const auto kernel = HWY_DYNAMIC_DISPATCH(threshold_rows);
    filter_row_bands(edge_responses, mask, threads, [&](const auto& from, const auto& to) {
        kernel(from, at_least, to);
    });
}

Mask threshold(const EdgeImage& image, int at_least) {
    Mask mask(image.width_px(), image.height_px());
    threshold(image.view(), at_least, mask.view());
    return mask;
}

}  // namespace ink::edge
#endif
