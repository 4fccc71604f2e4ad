#pragma once

#include <array>
#include <cstddef>

#include "raster/pass/pass.h"

namespace ink::buffers {

/// A tile of values with its halo, on the stack of the tile's thread; row(y)[x] in tile-local
/// coordinates.
template <class T>
class TileBuffer {
  public:
    static constexpr int kSpan = raster::kTileSize_px + 2 * raster::kMaxHalo_px;

    [[nodiscard]] T* row(int y) {
        return pixels_.data() + (y + raster::kMaxHalo_px) * kSpan + raster::kMaxHalo_px;
    }

  private:
    std::array<T, static_cast<std::size_t>(kSpan) * kSpan> pixels_;
};

/// The rows of a tile's values, wherever they lie.
template <class T>
struct TileRows {
    const T* origin = nullptr;  ///< local (0, 0)
    std::ptrdiff_t stride = 0;  ///< values from one row to the next

    TileRows() = default;
    TileRows(const T* origin_in, std::ptrdiff_t stride_in) : origin(origin_in), stride(stride_in) {}
    explicit TileRows(TileBuffer<T>& buffer)
        : origin(buffer.row(0)), stride(TileBuffer<T>::kSpan) {}
    [[nodiscard]] const T* row(int y) const { return origin + y * stride; }
};

using TileFloats = TileBuffer<float>;
using TilePlane = TileRows<float>;

}  // namespace ink::buffers
