#pragma once

#include <cstdint>
#include <vector>

#include "raster/tile_buffer.h"
#include "raster/triangle_stage.h"

namespace ink::raster {

/// Squares of a tile in which every stencil touches one triangle only.
inline constexpr int kFlatSquare_px = 16;
inline constexpr int kFlatSquares = kTileSize_px / kFlatSquare_px;  ///< each way

/// Proves of rectangles that one triangle alone is seen in them.
///
/// The proof is exact: the triangle covers every centre, its depth at each is more than that of any
/// other triangle that has a centre there (both are what the fill computes, which runs
/// monotonically along rows and columns, so corners tell), and no code of it is limited there, so
/// that codes are floors of one affine function. What such a rectangle holds is then known without
/// drawing it: a 5-point Laplacian of at most 2.
class FlatProof {
  public:
    /// More triangles than this in a tile, and nobody looks at it.
    static constexpr std::size_t kMostTriangles = 8;

    explicit FlatProof(const PassFormat& format) : format_(format) {}

    void start() { triangles_.clear(); }
    void add(const Batch& batch, std::uint32_t index) { triangles_.push_back({&batch, index}); }

    /// Whether one triangle alone is seen in all of `rect`.
    [[nodiscard]] bool is_flat(const PixelRect& rect) const;

    /// The squares of a tile of which that holds with `halo_px` more on every side: bit row *
    /// kFlatSquares + column. Squares at the picture's frame are never flat: beyond it, pixels are
    /// copies. 0 where it holds of a few only, and where there are more triangles than two: to find
    /// such squares, and to draw a tile in pieces, takes longer than what they spare.
    [[nodiscard]] std::uint16_t flat_squares(const TileBuffer& tile, int halo_px) const;

  private:
    struct Listed {
        const Batch* batch;
        std::uint32_t index;
        [[nodiscard]] const SetupTriangle& triangle() const { return batch->triangles[index]; }
    };
    [[nodiscard]] bool is_unlimited(const Listed& listed, const PixelRect& rect) const;

    PassFormat format_;
    std::vector<Listed> triangles_;
};

/// Where stencils of the squares that are not flat may read: rectangles that together hold them and
/// their halos. `flat` as flat_squares gives it.
[[nodiscard]] std::vector<PixelRect> needed_rects(const TileBuffer& tile,
                                                  std::uint16_t flat,
                                                  int halo_px);

}  // namespace ink::raster
