#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/bin.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/triangle_stage.h"

namespace ink::raster {

/// Proves of a part of a tile that one triangle alone is seen in it.
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

  private:
    struct Listed {
        const Batch* batch;
        std::uint32_t index;
        [[nodiscard]] const SetupTriangle& triangle() const { return batch->triangles[index]; }
    };
    [[nodiscard]] bool is_behind(const Listed& far,
                                 const Listed& near,
                                 const PixelRect& rect) const;
    [[nodiscard]] bool is_unlimited(const Listed& listed, const PixelRect& rect) const;

    PassFormat format_;
    std::vector<Listed> triangles_;
};

/// What one pass fills every tile with; borrowed.
struct FillJob {
    const PassFormat& format;
    const PassInput& input;
    const std::vector<Batch>& batches;
};

/// Rasterizes the listed triangles in order into a buffer that holds sky.
///
/// A pixel's value depends on the pixel and the triangle alone, never on the tile: so a halo pixel
/// has the bits that its own tile gives it. The plain loop that the kernels of triangle_fill.h
/// equal bit for bit. Returns whether anything is seen.
bool fill_tile(const FillJob& job, std::span<const BinEntry> entries, TileBuffer& buffer);

/// Draws one triangle that was set up by itself into a tile, in vectors: the same bits as
/// fill_function's plain loop.
///
/// False, and nothing done, where it has no kernel: codes run in perspective, or edges so long that
/// their steps leave 32 bits.
[[nodiscard]] bool fill_triangle(const FillJob& job, const BinEntry& entry, TileBuffer& buffer);

}  // namespace ink::raster
