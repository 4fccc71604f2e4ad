#include "raster/depth/depth_blocks.h"

#include <algorithm>
#include <limits>

#include "core/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/depth/depth_blocks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The least number in each block of some rows, which stand one behind the other.
void LeastOfBlocks(const std::uint32_t* from, int width_px, int rows, std::uint32_t* least) {
    const hn::CappedTag<std::uint32_t, DepthBlocks::kBlock_px> d;
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
    for (int x0 = 0; x0 < width_px; x0 += DepthBlocks::kBlock_px, ++least) {
        const int count = std::min(DepthBlocks::kBlock_px, width_px - x0);
        std::uint32_t found = kMost;
        auto found_lanes = hn::Set(d, kMost);
        const std::uint32_t* block = from + x0;
        for (int y = 0; y < rows; ++y, block += width_px) {
            if (count < DepthBlocks::kBlock_px) {
                found = std::min(found, *std::min_element(block, block + count));
                continue;
            }
            for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d)))
                found_lanes = hn::Min(found_lanes, hn::LoadU(d, block + x));
        }
        *least = std::min(found, hn::GetLane(hn::MinOfLanes(d, found_lanes)));
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(LeastOfBlocks);

void DepthBlocks::find(const core::Image<std::uint32_t>& bits, int threads) {
    const int columns = (bits.width_px() + kBlock_px - 1) / kBlock_px;
    const int rows = (bits.height_px() + kBlock_px - 1) / kBlock_px;
    if (least_.width_px() != columns || least_.height_px() != rows)
        least_ = core::Image<std::uint32_t>(columns, rows);
    core::parallel_for(static_cast<std::size_t>(rows), threads, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const int y0 = row * kBlock_px;
        HWY_DYNAMIC_DISPATCH(LeastOfBlocks)
        (bits.row(y0),
         bits.width_px(),
         std::min(kBlock_px, bits.height_px() - y0),
         least_.row(row));
    });
}

bool DepthBlocks::hides(const PixelRect& rect, std::uint32_t most) const {
    constexpr int kFew = 9;
    const int x0 = rect.x0 / kBlock_px;
    const int y0 = rect.y0 / kBlock_px;
    const int x1 = (rect.x1 - 1) / kBlock_px;
    const int y1 = (rect.y1 - 1) / kBlock_px;
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > kFew) return false;
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            if (least_.at(x, y) <= most) return false;
        }
    }
    return true;
}

}  // namespace ink::raster
#endif  // HWY_ONCE
