#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/mesh/cull_and_bin.h"
#include "raster/mesh/lane_depth_bias.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/pass/pass.h"
#include "raster/pass/setup.h"

namespace ink::raster {

/// Triangles at most this wide and high may become fragments, if their boxes have at most so many
/// pixels each on average.
inline constexpr int kFragmentExtent_px = 12;
inline constexpr std::size_t kFragmentArea_px = 12;

/// Pixels that the small triangles of one cluster cover: fragments, found once, when triangles are
/// sorted out, instead of tile by tile. What of them is seen is for the tile to say. Scratch of a
/// thread.
///
/// For each pixel they stand in the order of the triangles, so that of two at one depth the first
/// wins; those of different pixels stand as they come.
struct ClusterFragments {
    static constexpr std::size_t kCapacity = CullResult::kCapacity * kFragmentArea_px;
    /// x | y << 8 from the cluster's box, and the value << 16 if it fits.
    alignas(64) std::uint32_t words[kCapacity];
    alignas(64) float q[kCapacity];
    alignas(64) std::uint32_t values[kCapacity];  ///< u32 only
    std::size_t count = 0;
};

/// Whether lanes find a format's fragments: float depth and at most one plane, of integers.
[[nodiscard]] bool has_fragments(const PassFormat& format);

/// A cluster whose triangles become fragments; borrowed.
struct FragmentJob {
    const PassFormat& format;
    const LaneDepthBias& depth_bias;
    LaneRecords records;
    /// Arrays of the records that hold the value of triangles seen from their front and back.
    std::size_t values[2];
    const std::uint32_t* constants;  ///< per triangle, padded; of no use if the format has none
    PixelRect bounds;                ///< as LaneSlot has them, at most 256 px wide and high
};

/// Finds the fragments of what culling left: the pixels, depths and codes of lane_setup and
/// lane_fill, bit by bit. Some may lie outside the image. Triangles are as small as said above.
void find_fragments(const FragmentJob& job, const CullResult& culled, ClusterFragments& out);

/// The fragments of a cluster in one tile: first all words (place | value << 16 if it fits), then
/// all q, then all values of u32, each padded for vectors. A place is an element of TileBuffer's
/// planes.
class FragmentBlock {
  public:
    FragmentBlock(const std::byte* data, std::size_t count)
        : data_(data), padded_(lane_padded(count)) {}

    [[nodiscard]] static std::size_t byte_count(const PassFormat& format, std::size_t count) {
        const std::size_t arrays = has_wide_values(format) ? 3 : 2;
        return arrays * lane_padded(count) * sizeof(std::uint32_t);
    }
    [[nodiscard]] static bool has_wide_values(const PassFormat& format) {
        return format.store == Store::u32;
    }
    [[nodiscard]] const std::uint32_t* words() const {
        return reinterpret_cast<const std::uint32_t*>(data_);
    }
    [[nodiscard]] const float* q() const {
        return reinterpret_cast<const float*>(words()) + padded_;
    }
    [[nodiscard]] const std::uint32_t* values() const { return words() + 2 * padded_; }

  private:
    const std::byte* data_;
    std::size_t padded_;
};

/// Where a cluster's fragments go.
struct FragmentTile {
    PixelRect own;    ///< the tile's own pixels
    PixelRect drawn;  ///< those to keep
};

/// Writes a block of those of a cluster's fragments that a tile draws, where there is room for all
/// of them and a vector more; returns how many.
std::size_t keep_fragments(const PassFormat& format,
                           const ClusterFragments& fragments,
                           const PixelRect& bounds,
                           const FragmentTile& tile,
                           std::byte* to);

class TileBuffer;

/// Draws `count` fragments of a block in order into the tile that they were kept for.
void fill_fragments(const PassFormat& format,
                    const FragmentBlock& block,
                    std::size_t count,
                    TileBuffer& to);

}  // namespace ink::raster
