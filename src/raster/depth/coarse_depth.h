#pragma once

#include <array>
#include <cstdint>

#include "core/image.h"
#include "raster/pass/setup.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {

/// A lower bound of the depth in each 16 x 16 square of a tile: what lies behind it in all of its
/// pixels is not seen. The squares at a tile's rim take its halo in.
///
/// It is looked up after every so many triangles, not kept up at every pixel, so it lags behind:
/// what it calls hidden is, what it does not may be.
class CoarseDepth {
  public:
    static constexpr int kSquare_px = 16;
    static constexpr int kSquares = kTileSize_px / kSquare_px;

    using Squares = std::array<std::array<float, kSquares>, kSquares>;

    explicit CoarseDepth(DepthFormat format) : is_in_steps_(format != DepthFormat::q32) {}

    /// Knows nothing of a new tile.
    void start(TileBuffer& buffer);
    /// Says that so many triangles are drawn next.
    void announce(std::size_t triangles) { drawn_ += triangles; }
    /// Whether enough were drawn since the last time to read the tile's depth again.
    [[nodiscard]] bool wants_refresh() const { return drawn_ >= pause_; }
    /// Reads it: all that was announced is drawn.
    void refresh();
    /// What it read, row by row.
    [[nodiscard]] const Squares& least() const { return least_; }
    /// Whether nothing of depth `q_most` or farther can be seen in `bounds`, in the image's
    /// coordinates; only what lies in the tile counts. A step, at least 1, where the format has
    /// them.
    [[nodiscard]] bool hides(const PixelRect& bounds, float q_most) const;

  private:
    template <class T>
    void refresh_as();

    bool is_in_steps_;
    TileBuffer* buffer_ = nullptr;
    std::size_t drawn_ = 0;  ///< since the last refresh
    std::size_t pause_ = 0;  ///< triangles until the next
    bool is_known_ = false;
    Squares least_{};
};

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
