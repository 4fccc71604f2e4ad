#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/roberts_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/roberts.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void cross_rows(const core::ImageView<const float>& values, const core::ImageView<float>& out) {
    for (int y = 0; y < out.height_px; ++y) {
        const float* upper = values.row(y);
        const float* lower = upper + values.stride;
        float* to = out.row(y);
        constexpr int kLanes = HWY_LANES(float);
        cover<float, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto falling = hn::AbsDiff(hn::LoadU(d, upper + x), hn::LoadU(d, lower + x + 1));
            const auto rising = hn::AbsDiff(hn::LoadU(d, upper + x + 1), hn::LoadU(d, lower + x));
            hn::StoreU(hn::Add(falling, rising), d, to + x);
        });
    }
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(cross_rows);

}  // namespace

void roberts(const core::ImageView<const float>& values,
             const core::ImageView<float>& out,
             int threads) {
    filter_row_bands(values, out, threads, HWY_DYNAMIC_DISPATCH(cross_rows));
}

}  // namespace ink::edge
#endif
