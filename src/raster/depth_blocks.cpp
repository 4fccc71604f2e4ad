#include "raster/depth_blocks.h"

#include <algorithm>
#include <limits>

#include "core/parallel.h"

namespace ink::raster {

void DepthBlocks::find(const core::Image<std::uint32_t>& bits, int threads) {
    const int columns = (bits.width_px() + kBlock_px - 1) / kBlock_px;
    const int rows = (bits.height_px() + kBlock_px - 1) / kBlock_px;
    if (least_.width_px() != columns || least_.height_px() != rows)
        least_ = core::Image<std::uint32_t>(columns, rows);
    core::parallel_for(static_cast<std::size_t>(rows), threads, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        std::uint32_t* const least = least_.row(row);
        std::fill_n(least, columns, std::numeric_limits<std::uint32_t>::max());
        const int y1 = std::min((row + 1) * kBlock_px, bits.height_px());
        for (int y = row * kBlock_px; y < y1; ++y) {
            for (int column = 0; column < columns; ++column) {
                const int x0 = column * kBlock_px;
                const std::uint32_t* const from = bits.row(y) + x0;
                const int count = std::min(kBlock_px, bits.width_px() - x0);
                std::uint32_t found = least[column];
                for (int x = 0; x < count; ++x)
                    found = std::min(found, from[x]);
                least[column] = found;
            }
        }
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
