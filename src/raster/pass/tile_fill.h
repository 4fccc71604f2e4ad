#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/bin.h"
#include "raster/pass/tile_buffer.h"

namespace ink::raster {

/// What one pass fills every tile with; borrowed.
struct FillJob {
    const PassFormat& format;
    const PassInput& input;
    const std::vector<Batch>& batches;
};

/// Pixel centres met in one tile, halo included.
struct FillCounts {
    std::uint64_t covered = 0;  ///< inside a triangle
    std::uint64_t kept = 0;     ///< of these, nearer than what was there
};

/// Rasterizes the listed triangles in order into a buffer that holds sky.
///
/// A pixel's value depends on the pixel and the triangle alone, never on the tile: so a halo pixel
/// has the bits that its own tile gives it.
using FillTile = FillCounts (*)(const FillJob& job,
                                std::span<const BinEntry> entries,
                                TileBuffer& buffer);

/// The fill function compiled for `format`; a format outside the closed set is an assertion.
///
/// The plain loop that the kernels of triangle_fill.h equal bit for bit.
[[nodiscard]] FillTile fill_function(const PassFormat& format);

}  // namespace ink::raster
