#pragma once

#include <cstdint>

#include "raster/mesh/cluster_stage.h"
#include "raster/mesh/lane_mesh.h"
#include "raster/pass/setup.h"
#include "raster/pass/tile_lists.h"

namespace ink::raster {

/// Triangles at most this wide and high go through lanes: every product of two extents in 1/256 px,
/// and their difference, then fits 32 bits.
inline constexpr int kLaneExtent_px = 127;

/// What is asked of a cluster's triangles.
struct CullJob {
    PixelRect image;
    bool drops_backs = false;      ///< triangles seen from their back are of no use
    bool drops_fronts = false;     ///< nor are those seen from their front
    bool drops_no_sample = false;  ///< so are those that cover no pixel centre
};

/// The triangles that are left, in order.
struct CullResult {
    /// Up to a whole vector more is written.
    static constexpr std::size_t kCapacity = 128 + kLanePad;
    /// As LaneMesh::corners has them, with kBackSide where they are seen from their back.
    alignas(64) std::uint32_t corners[kCapacity];
    /// Pixel centres that may be inside: first | end << 16.
    alignas(64) std::int32_t x_span[kCapacity];
    alignas(64) std::int32_t y_span[kCapacity];
    /// Which of them are seen so nearly edge-on that their side is not sure; kBackSide is unset.
    alignas(64) std::uint32_t unsure[kCapacity];
    std::size_t count = 0;
    std::size_t unsure_count = 0;
    bool has_back = false;      ///< some is surely seen from its back
    int extent_px = 0;          ///< the greatest width or height of their boxes
    std::size_t area_px = 0;    ///< of all boxes
    bool has_large = false;     ///< some triangle exceeds kLaneExtent_px: nothing here is of use
    std::size_t no_sample = 0;  ///< dropped or not, triangles found to cover no centre
    std::size_t outside = 0;    ///< without a centre in the image
};

/// Sorts out the triangles of a projected cluster: those outside the image, without area, or
/// (where the job says so) turned away or without a sample are dropped. A triangle seen so nearly
/// edge-on that its facing is not sure is never dropped for it.
void cull_cluster(const LaneMesh& mesh,
                  std::size_t cluster,
                  const ClusterLanes& lanes,
                  const CullJob& job,
                  CullResult& result);

/// Appends the numbers of those triangles of a result whose centres lie in one of the columns and
/// rows of `rect`, each with `base` in its upper bits; returns how many.
std::size_t list_triangles(const CullResult& result,
                           const PixelRect& rect,
                           std::uint32_t base,
                           EntryList& to);
/// How many that would be.
[[nodiscard]] std::size_t count_triangles(const CullResult& result, const PixelRect& rect);
/// The same as list_triangles for all of them.
void list_all_triangles(const CullResult& result, std::uint32_t base, EntryList& to);

}  // namespace ink::raster
