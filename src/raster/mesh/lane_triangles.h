#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/mesh/lane_depth_bias.h"
#include "raster/mesh/lane_mesh.h"
#include "raster/pass/pass.h"
#include "raster/pass/setup.h"

namespace ink::raster {

class TileBuffer;

/// A cluster's vertices as they are kept for a frame, one array of `stride` numbers after the
/// other: x, y (1/65536 px), q, the values; and for triangles seen from their back, where those
/// read something else, q or the values once more. Borrowed.
struct LaneRecords {
    std::byte* data = nullptr;
    std::size_t stride = 0;

    /// The most arrays that a format asks for.
    static constexpr std::size_t kMostArrays = 3 + 2 * kMaxPlanes;

    [[nodiscard]] std::int32_t* x() const { return reinterpret_cast<std::int32_t*>(data); }
    [[nodiscard]] std::int32_t* y() const { return x() + stride; }
    [[nodiscard]] float* array(std::size_t k) const {
        return reinterpret_cast<float*>(data) + k * stride;
    }
    [[nodiscard]] float* q() const { return array(2); }
};

/// A drawn cluster: its vertices, and behind them the corners of the triangles that are left of it,
/// and those triangles' constants if the format has any. Or its fragments in one tile.
struct alignas(64) LaneSlot {
    std::size_t first_byte = 0;  ///< of its records and its triangles' corners
    std::uint32_t byte_count = 0;
    std::uint32_t stride = 0;
    /// Arrays of its records that triangles seen from their front and from their back have q in,
    /// and their first value.
    std::uint8_t q[2] = {2, 2};
    std::uint8_t values[2] = {3, 3};
    std::uint8_t corners = 3;     ///< the array that its triangles' corners begin in
    bool is_late = false;         ///< as ClusterOrder has it
    std::uint32_t constants = 0;  ///< where they begin, in numbers from its records
    std::uint32_t fragments = 0;  ///< how many, in a FragmentBlock; of `triangles` triangles
    std::uint32_t triangles = 0;
    float q_most = 0;  ///< of its vertices, biased
    PixelRect bounds;  ///< of the centres its triangles may cover
};

/// A triangle in a tile's list is one number: slot << 8 | triangle, of those of the slot; or, with
/// kScalarTriangle set, the index of one that was set up by itself. kAllFragments in place of a
/// triangle: the fragments of the slot.
inline constexpr std::uint32_t kScalarTriangle = 1U << 31;
inline constexpr std::uint32_t kAllFragments = 0xff;
static_assert(scene::kMaxClusterTriangles <= kAllFragments);
[[nodiscard]] constexpr bool is_scalar(std::uint32_t entry) {
    return (entry & kScalarTriangle) != 0;
}
[[nodiscard]] constexpr bool is_fragments(std::uint32_t entry) {
    return !is_scalar(entry) && (entry & 0xff) == kAllFragments;
}
/// The corners of a slot's triangle are what LaneMesh::corners has, with this set where it is seen
/// from its back.
inline constexpr std::uint32_t kBackSide = 1U << 31;

/// Where lanes find a list's triangles; borrowed.
struct LaneSource {
    const LaneSlot* slots = nullptr;
    const std::byte* records = nullptr;

    void prefetch_slot(std::uint32_t entry) const { hwy::Prefetch(slots + (entry >> 8)); }
    /// Asks for what a slot holds ahead of its use.
    void prefetch(const LaneSlot& slot) const {
        constexpr std::size_t kLineBytes = 64;
        for (std::size_t byte = 0; byte < slot.byte_count; byte += kLineBytes)
            hwy::Prefetch(records + slot.first_byte + byte);
    }
};

/// Whether lanes can draw a format: affine, and of a store that is used; a constant by itself, not
/// one added to a code.
[[nodiscard]] bool lanes_can_draw(const PassFormat& format);

/// Bits after the point of a code in 32-bit lanes: as many as leave room for what a corner may
/// reach beyond the store's range.
[[nodiscard]] constexpr int lane_fraction_bits(Store store) {
    return store == Store::u16 ? 14 : 16;
}

/// Values of a cluster's vertices that lanes can take: beyond these, 32 bits might overflow.
[[nodiscard]] bool lanes_can_hold(const PassFormat& format, float least, float greatest);

/// Some triangles set up for one tile, one array per number.
///
/// Everything is relative to a pixel beside the triangle, its reference: at(x, y) = at_ref + dx (x
/// - ref_x) + dy (y - ref_y). Edges are in 1/256 px squared over 256, exact: a centre is inside
/// where none is negative.
struct LaneTriangles {
    static constexpr std::size_t kCount = 64;
    using Ints = std::int32_t[kCount];
    using Floats = float[kCount];

    struct Codes {
        alignas(64) Ints at_ref, dx, dy, low, high;
    };
    struct Numbers {
        alignas(64) Floats at_ref, dx, dy, low, high;
    };

    std::size_t count = 0;
    alignas(64) Ints x0, y0, x1, y1;  ///< what of its box is drawn in this tile
    alignas(64) Ints ref_x, ref_y;
    alignas(64) Ints edge_at_ref[3], edge_dx[3], edge_dy[3];
    /// Where the first column of vectors starts that is drawn of it.
    alignas(64) Ints first_x;
    /// Columns of vectors of eight pixels: as many as a tile with its halo is wide.
    static constexpr int kColumn_px = 8;
    static constexpr std::size_t kColumns = 10;
    /// Per column, the rows that it may cover, from y0 on: first | end << 16. On targets whose
    /// vectors have eight pixels, and up to the widest triangle of a vector only.
    alignas(64) Ints rows[kColumns];
    /// -1 where planes must be kept within `low` and `high` at every pixel: thin triangles, whose
    /// gradients are noise, and codes that come near the ends of their store.
    alignas(64) Ints needs_limits;
    Numbers q;
    alignas(64) std::int32_t constants[kCount + kLanePad];  ///< u32, if the format has them
    Codes codes[2];                                         ///< integer stores
    Numbers numbers[kMaxPlanes];                            ///< f32
    /// The corners as they come, a vector's worth more than there is room for.
    static constexpr std::size_t kPadded = kCount + kLanePad;
    struct Corners {
        alignas(64) std::int32_t x[kPadded];
        alignas(64) std::int32_t y[kPadded];
        alignas(64) float q[kPadded];
        alignas(64) float values[kMaxPlanes][kPadded];
    };
    Corners corners[3];
};

/// Sets up at most LaneTriangles::kCount listed triangles, none of them of the scalar path, for the
/// pixels `drawn`; their depth is moved by `depth_bias`.
void set_up_lanes(const PassFormat& format,
                  const LaneSource& source,
                  std::span<const std::uint32_t> entries,
                  const PixelRect& drawn,
                  const LaneDepthBias& depth_bias,
                  LaneTriangles& out);

/// Finds, for triangles that are set up, the columns of vectors that fill_lanes draws, and which of
/// their rows each triangle may cover: LaneTriangles::first_x and rows.
void find_rows(LaneTriangles& triangles);

/// Draws them in order into a tile.
void fill_lanes(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to);

}  // namespace ink::raster
