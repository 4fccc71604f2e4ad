#pragma once

#include <cstdint>

#include "core/image.h"
#include "raster/pass/setup.h"

namespace ink::raster {

/// The least depth in each block of a frame's depth: what lies behind it all over the blocks that
/// it touches is not seen.
class DepthBlocks {
  public:
    static constexpr int kBlock_px = 16;

    /// Reads a whole frame.
    void find(const core::Image<std::uint32_t>& bits, int threads);

    /// Whether every pixel of the rectangle, which is not empty and lies in the frame, is nearer
    /// than `most`. False where that would take more than a few blocks to say.
    [[nodiscard]] bool hides(const PixelRect& rect, std::uint32_t most) const;

  private:
    core::Image<std::uint32_t> least_;
};

}  // namespace ink::raster
