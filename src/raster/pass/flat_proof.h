#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/pass/needed_rows.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/triangle_rows.h"
#include "raster/pass/triangle_stage.h"

namespace ink::raster {

/// Proves of parts of a tile that no more than one triangle is seen in them.
///
/// The proof is exact: the triangle covers every centre, no other triangle has a centre there or
/// its depth at each is less (both are what the fill computes, which runs monotonically along rows
/// and columns, so corners tell), and no code of it is limited there, so that codes are floors of
/// one affine function. What such a part holds is then known without drawing it: a 5-point
/// Laplacian of at most 2.
class FlatProof {
  public:
    /// More triangles than this in a tile, and nobody looks at it.
    static constexpr std::size_t kMostTriangles = 8;

    explicit FlatProof(const PassFormat& format) : format_(format) {}

    void start() { triangles_.clear(); }
    void add(const Batch& batch, std::uint32_t index) { triangles_.push_back({&batch, index}); }

    /// Whether one triangle alone is seen in all of `rect`.
    [[nodiscard]] bool is_flat(const PixelRect& rect) const;

    /// Finds the stencils of a tile, `halo_px` on every side, in which two triangles may be met, or
    /// one and sky. What is left out, above and below a run, lies inside one triangle or in the
    /// sky. At the image's frame all are needed: beyond it, pixels are copies.
    ///
    /// False, and `needed` unspecified, where it spares too little to be worth its while, and where
    /// there are more than three triangles.
    [[nodiscard]] bool find_needed(const TileBuffer& tile, int halo_px, NeededRows& needed);

  private:
    struct Listed {
        const Batch* batch;
        std::uint32_t index;
        [[nodiscard]] const SetupTriangle& triangle() const { return batch->triangles[index]; }
    };
    [[nodiscard]] RowRun lone_rows(const PixelRect& column, std::size_t at) const;
    [[nodiscard]] bool is_behind(const Listed& far,
                                 const Listed& near,
                                 const PixelRect& rect) const;
    [[nodiscard]] bool is_unlimited(const Listed& listed, const PixelRect& rect) const;

    PassFormat format_;
    std::vector<Listed> triangles_;
    std::vector<TriangleRows> met_;
};

}  // namespace ink::raster
