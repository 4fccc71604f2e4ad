#include "raster/depth/depth_image.h"

#include <algorithm>
#include <cstring>

namespace ink::raster {

void DepthImage::start(DepthFormat format, double near, double far, int width_px, int height_px) {
    format_ = format;
    near_ = near;
    far_ = far;
    if (bits_.width_px() != width_px || bits_.height_px() != height_px)
        bits_ = core::Image<std::uint32_t>(width_px, height_px);
}

void DepthSink::finish(const Tile& tile) {
    core::Image<std::uint32_t>& bits = image_.bits();
    for (int y = 0; y < tile.height_px; ++y) {
        std::uint32_t* to = bits.row(tile.y0_px + y) + tile.x0_px;
        const auto count = static_cast<std::size_t>(tile.width_px);
        if (tile.is_empty) {
            std::fill_n(to, count, 0U);
        } else {
            std::memcpy(to, tile.depth_row<std::uint32_t>(y), count * sizeof(std::uint32_t));
        }
    }
}

}  // namespace ink::raster
